// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/edges.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "support/guarded.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

/// @file
/// Every kernel of this machine gives the sums of plain integers, to the bit, whatever the length of the row, and
/// touches nothing beyond it: each row lies against a page that may not be touched.

namespace {

namespace kernel = dot::kernel;
using dot::test::Guarded;
using dot::test::kernel_variants;
using dot::test::Random;

constexpr int lengths[] = {1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 100, 619};

/// Three rows of an image, black and white or of all grey values.
struct Rows {
  Rows(int n, bool at_the_end)
      : n_(n),
        above_(static_cast<std::size_t>(n), at_the_end),
        here_(static_cast<std::size_t>(n) + 2, at_the_end),
        below_(static_cast<std::size_t>(n), at_the_end) {}

  void paint(Random& random, bool black_and_white) {
    const auto value = [&] {
      const double grey = random.uniform(0, 256);
      return static_cast<unsigned char>(black_and_white ? (grey < 128 ? 0 : 255) : grey);
    };
    for (int x = 0; x < n_; ++x) above_.bytes()[x] = value(), below_.bytes()[x] = value();
    for (int x = 0; x < n_ + 2; ++x) here_.bytes()[x] = value();
  }

  kernel::ThreeRows get() const { return {above_.bytes(), here_.bytes() + 1, below_.bytes()}; }
  int gx(int x) const { return here_.bytes()[x + 2] - here_.bytes()[x]; }
  int gy(int x) const { return below_.bytes()[x] - above_.bytes()[x]; }

 private:
  int n_;
  Guarded above_, here_, below_;
};

TEST(EdgeKernels, CompareEdges) {
  Random random(1);
  for (const bool at_the_end : {true, false})
    for (const int n : lengths) {
      const auto size = static_cast<std::size_t>(n);
      Rows now(n, at_the_end), before(n, at_the_end);
      const Guarded part(2 * size, at_the_end), all(2 * size, at_the_end);
      const kernel::EdgeColumns columns{reinterpret_cast<unsigned short*>(part.bytes()),
                                        reinterpret_cast<unsigned short*>(all.bytes())};
      for (const kernel::Kernels* k : kernel_variants()) {
        std::fill_n(columns.part, n, 0), std::fill_n(columns.all, n, 0);
        std::vector<int> changes(size), lengths_of_all(size);
        for (int row = 0; row < 4; ++row) {
          now.paint(random, row % 2 == 0), before.paint(random, row % 2 == 0);
          k->compare_edges(now.get(), before.get(), n, columns);
          for (int x = 0; x < n; ++x) {
            const auto i = static_cast<std::size_t>(x);
            changes[i] += std::abs(now.gx(x) - before.gx(x)) + std::abs(now.gy(x) - before.gy(x));
            lengths_of_all[i] +=
                std::abs(now.gx(x)) + std::abs(now.gy(x)) + std::abs(before.gx(x)) + std::abs(before.gy(x));
            ASSERT_EQ(columns.part[x], changes[i]) << k->name << ": " << x << " of " << n;
            ASSERT_EQ(columns.all[x], lengths_of_all[i]) << k->name << ": " << x << " of " << n;
          }
        }
      }
    }
}

// The same image for many frames gives the longest sums; other images, edges that stay in part.
TEST(EdgeKernels, SumEdges) {
  Random random(2);
  constexpr int kEdge = 60, kFrames = 30;
  int staying = 0, moving = 0;
  constexpr short kFade = 10100;  // of 2^16: at 10 Hz, with a time constant of 0.6 s
  for (const bool at_the_end : {true, false})
    for (const bool changes : {true, false})
      for (const int n : lengths) {
        const auto size = static_cast<std::size_t>(n);
        Rows image(n, at_the_end);
        const Guarded x(2 * size, at_the_end), y(2 * size, at_the_end), length(2 * size, at_the_end);
        const Guarded part(2 * size, at_the_end), all(2 * size, at_the_end), stays(size, at_the_end);
        const auto shorts = [](const Guarded& g) { return reinterpret_cast<short*>(g.bytes()); };
        const kernel::EdgeColumns columns{reinterpret_cast<unsigned short*>(part.bytes()),
                                          reinterpret_cast<unsigned short*>(all.bytes())};
        kernel::EdgeSums sums;
        sums.x = shorts(x), sums.y = shorts(y), sums.length = shorts(length);
        sums.fade = kFade, sums.edge = kEdge;
        for (const kernel::Kernels* k : kernel_variants()) {
          for (short* a : {sums.x, sums.y, sums.length}) std::fill_n(a, n, short{0});
          std::vector<std::array<int, 3>> expected(size);  // sums of gx, gy and lengths
          image.paint(random, !changes);
          for (int frame = 0; frame < kFrames; ++frame) {
            if (changes && frame % 2) image.paint(random, false);
            std::fill_n(columns.part, n, 0), std::fill_n(columns.all, n, 0);
            k->sum_edges(image.get(), n, sums, columns, stays.bytes());
            for (int i = 0; i < n; ++i) {
              auto& [sx, sy, all_lengths] = expected[static_cast<std::size_t>(i)];
              const int gx = kernel::kEdgeUnit * image.gx(i), gy = kernel::kEdgeUnit * image.gy(i);
              const auto add = [](int& sum, int value) { sum += value - ((sum * kFade) >> 16); };
              add(sx, gx), add(sy, gy), add(all_lengths, std::abs(gx) + std::abs(gy));
              ASSERT_LE(all_lengths, 16383) << "a precondition: four lengths must fit into 16 bits";
              const bool is_edge = all_lengths > kEdge;
              const int sum = std::abs(sx) + std::abs(sy);
              ASSERT_EQ(columns.part[i], is_edge ? sum : 0) << k->name << ": " << i << " of " << n;
              ASSERT_EQ(columns.all[i], is_edge ? all_lengths : 0) << k->name << ": " << i << " of " << n;
              ASSERT_EQ(stays.bytes()[i], is_edge && 10 * sum > 9 * all_lengths) << k->name << ": " << i << " of " << n;
              ++(stays.bytes()[i] ? staying : moving);
            }
          }
        }
      }
  EXPECT_GT(staying, 0);
  EXPECT_GT(moving, 0);
}

}  // namespace
