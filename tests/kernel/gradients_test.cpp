// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/gradients.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/guarded.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

namespace {

namespace kernel = dot::kernel;
using dot::test::Guarded;
using dot::test::kernel_variants;
using dot::test::Random;

TEST(GradientKernel, FindsTheStrongestOfEachColumn) {
  Random random(3);
  for (const int width : {1, 5, 16, 33, 100})
    for (const int rows : {1, 2, 12}) {
      // All arrays lie against pages that may not be touched.
      const int stride = width + 2;
      const auto pixels = static_cast<std::size_t>(width * rows);
      const Guarded grey(static_cast<std::size_t>(stride * (rows + 2)), true), mask(pixels, true);
      const Guarded q(4 * pixels, true), keys(4 * static_cast<std::size_t>(width), true);
      // Few values, so that many gradients are equal; the extremes among them.
      for (int i = 0; i < stride * (rows + 2); ++i)
        grey.bytes()[i] = static_cast<unsigned char>(85 * static_cast<int>(random.uniform(0, 4)));
      for (int i = 0; i < width * rows; ++i) {
        mask.bytes()[i] = random.uniform() < 0.7 ? (random.uniform() < 0.5 ? 255 : 1) : 0;
        const float depths[] = {0.5f, 1e-30f, 0.f, -1.f, std::numeric_limits<float>::quiet_NaN()};
        q.floats()[i] = depths[static_cast<int>(random.uniform(0, 5))];
      }
      kernel::GradientStrip strip;
      strip.grey = grey.bytes() + stride + 1, strip.grey_stride = stride;
      strip.mask = mask.bytes(), strip.mask_stride = width;
      strip.q_stride = 4 * width;
      strip.width = width, strip.rows = rows;
      for (const bool measured_alone : {true, false})
        for (const int threshold : {0, 20000}) {
          strip.q = measured_alone ? q.floats() : nullptr;
          for (const kernel::Kernels* k : kernel_variants()) {
            int* const found = reinterpret_cast<int*>(keys.bytes());
            k->strongest_gradients(strip, threshold, found);
            for (int x = 0; x < width; ++x) {
              int best = threshold, row = 0;
              for (int y = 0; y < rows; ++y) {
                const unsigned char* p = strip.grey + y * stride + x;
                const int gx = p[1] - p[-1], gy = p[stride] - p[-stride], g = gx * gx + gy * gy;
                const bool counts = mask.bytes()[y * width + x] && (!measured_alone || q.floats()[y * width + x] > 0);
                if (counts && g > best) best = g, row = y;
              }
              EXPECT_EQ(strip.gradient_of(found[x]), best) << k->name;
              EXPECT_EQ(strip.row_of(found[x]), row) << k->name;
            }
          }
        }
    }
}

TEST(GradientKernel, KeysOfTheTallestStripFit) {
  kernel::GradientStrip strip;
  strip.rows = kernel::kMaxStripRows;
  const int key = strip.key(2 * 255 * 255, 7);
  EXPECT_EQ(strip.gradient_of(key), 2 * 255 * 255);
  EXPECT_EQ(strip.row_of(key), 7);
}

}  // namespace
