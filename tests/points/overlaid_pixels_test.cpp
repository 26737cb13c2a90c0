// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/overlaid_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

namespace {

using dot::Image;
using dot::OverlaidPixels;

Image<std::uint8_t> cut(const OverlaidPixels& pixels, int x, int y, int width, int height) {
  Image<std::uint8_t> mask(width, height);
  mask.fill(255);
  pixels.cut(x, y, mask.view());
  return mask;
}

TEST(OverlaidPixels, AreNoneAtFirst) {
  OverlaidPixels pixels;
  EXPECT_FALSE(pixels.any());
  EXPECT_EQ(cut(pixels, 0, 0, 8, 8)(3, 3), 255);
}

// Of squares of 4 pixels in an image that is no multiple of them: 8 x 6 squares are 32 x 24 of 35 x 26 pixels.
TEST(OverlaidPixels, AreCutOutOfAMaskAnywhere) {
  OverlaidPixels pixels;
  pixels.set(4, 8, 6);
  pixels.add(2, 3);
  pixels.add(7, 5);
  const auto is_overlaid = [](int u, int v) {
    const int column = std::min(u / 4, 7), row = std::min(v / 4, 5);
    return (column >= 1 && column <= 3 && row >= 2 && row <= 4) || (column >= 6 && row >= 4);
  };
  for (const auto& [x, y, width, height] : {std::array{0, 0, 35, 26}, {5, 9, 20, 9}, {33, 25, 2, 1}, {14, 0, 1, 26}}) {
    const Image<std::uint8_t> mask = cut(pixels, x, y, width, height);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        ASSERT_EQ(mask(u, v), is_overlaid(x + u, y + v) ? 0 : 255) << x << ' ' << y << ": " << u << ' ' << v;
  }
  pixels.clear();
  EXPECT_EQ(cut(pixels, 0, 0, 35, 26)(9, 13), 255);
}

}  // namespace
