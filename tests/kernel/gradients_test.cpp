// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/gradients.hpp"

#include <gtest/gtest.h>

#include <cstddef>
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

// Every third row of eight: the neighbours of a pixel are still those of the image.
TEST(GradientKernel, SearchesEveryFewRows) {
  constexpr int width = 21, step = 3, height = 8, stride = width + 2;
  Random random(4);
  std::vector<unsigned char> grey(stride * (height + 2)), mask(width * height);
  std::vector<float> q(width * height, 1);
  for (auto& each : grey) each = static_cast<unsigned char>(random.uniform(0, 256));
  for (float& each : q) each = random.uniform() < 0.8 ? 1.f : 0.f;
  for (auto& each : mask) each = random.uniform() < 0.8 ? 1 : 0;
  kernel::GradientStrip strip;
  strip.grey = grey.data() + stride + 1, strip.grey_stride = stride;
  strip.mask = mask.data(), strip.mask_stride = width;
  strip.q = q.data(), strip.q_stride = 4 * width;
  strip.width = width, strip.rows = (height + step - 1) / step, strip.row_step = step;
  for (const kernel::Kernels* k : kernel_variants()) {
    std::vector<int> keys(width);
    k->strongest_gradients(strip, 0, keys.data());
    for (int x = 0; x < width; ++x) {
      int best = 0, row = 0;
      for (int y = 0; y < height; y += step) {
        const unsigned char* p = strip.grey + y * stride + x;
        const int gx = p[1] - p[-1], gy = p[stride] - p[-stride], g = gx * gx + gy * gy;
        const auto i = static_cast<std::size_t>(y * width + x);
        if (q[i] > 0 && mask[i] && g > best) best = g, row = y;
      }
      const int found = keys[static_cast<std::size_t>(x)];
      EXPECT_EQ(strip.gradient_of(found), best) << k->name;
      EXPECT_EQ(step * strip.row_of(found), row) << k->name;
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
