// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/background_mask.hpp"

#include <array>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace {

using dot::BackgroundMask;
using dot::Mask;
using dot::PaintedImage;

/// Whether an object is within the margin, by definition.
bool is_near_an_object(const dot::Image<std::uint8_t>& labels, int x, int y) {
  for (int v = y - BackgroundMask::kMargin; v <= y + BackgroundMask::kMargin; ++v)
    for (int u = x - BackgroundMask::kMargin; u <= x + BackgroundMask::kMargin; ++u)
      if (labels.contains(u, v) && labels(u, v) != 0) return true;
  return false;
}

TEST(BackgroundMask, LeavesOutObjectsWithTheirMargin) {
  constexpr int kWidth = 50, kHeight = 40;
  std::mt19937 random(3);
  PaintedImage<std::uint8_t> labels;
  BackgroundMask background;
  for (int trial = 0; trial < 200; ++trial) {
    labels.clear(kWidth, kHeight);
    for (int object = trial % 4; object > 0; --object) {
      const int width = 1 + static_cast<int>(random() % 20), height = 1 + static_cast<int>(random() % 20);
      const std::array<int, 4> box{static_cast<int>(random() % (kWidth - width + 1u)),
                                   static_cast<int>(random() % (kHeight - height + 1u)), width, height};
      dot::Image<std::uint8_t> ragged(kWidth, kHeight);
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) ragged(x, y) = random() % 5 == 0;
      Mask mask;
      dot::fill_mask(
          box, [&](int x, int y) { return ragged(x, y) != 0; }, mask);
      labels.paint(mask, 1);
    }
    background.set(labels);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        ASSERT_EQ(background.pixels(x, y), is_near_an_object(labels.image(), x, y) ? 0 : 255)
            << trial << ": " << x << ' ' << y;
  }
}

TEST(BackgroundMask, LeavesOutBoxesThatItIsGiven) {
  PaintedImage<std::uint8_t> labels;
  labels.clear(50, 40);
  BackgroundMask background;
  background.set(labels, {{{10, 5, 20, 8}, {28, 10, 22, 30}}});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) {
      const bool in_box = (x >= 10 && x < 30 && y >= 5 && y < 13) || (x >= 28 && y >= 10);
      ASSERT_EQ(background.pixels(x, y), in_box ? 0 : 255) << x << ' ' << y;
    }
}

}  // namespace
