// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/morphology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "support/random.hpp"

namespace {

using dot::Image;
using dot::test::Random;

template <int kReach, typename T>
void expect_extremes(int width, int height, Random& random) {
  Image<T> image(width, height), rows, high(width, height), low(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image(x, y) = static_cast<T>(random.uniform(0, 250));
  dot::dilate<kReach>(std::as_const(image).view(), rows, high.view());
  dot::erode<kReach>(std::as_const(image).view(), rows, low.view());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      T most = image(x, y), least = most;
      for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, height - 1); ++v)
        for (int u = std::max(x - kReach, 0); u <= std::min(x + kReach, width - 1); ++u)
          most = std::max(most, image(u, v)), least = std::min(least, image(u, v));
      ASSERT_EQ(high(x, y), most) << x << ", " << y << " of " << width << " x " << height;
      ASSERT_EQ(low(x, y), least) << x << ", " << y << " of " << width << " x " << height;
    }
  dot::dilate<kReach>(std::as_const(image).view(), rows, image.view());  // in place
  EXPECT_TRUE(std::equal(image.row(0), image.row(height), high.row(0)));
}

TEST(Morphology, TakesTheExtremeOfEachWindow) {
  Random random(2);
  for (const auto& [width, height] : {std::pair{50, 20}, {1, 1}, {3, 2}, {5, 9}, {8, 8}, {9, 1}, {1, 30}}) {
    expect_extremes<1, std::uint8_t>(width, height, random);
    expect_extremes<2, std::uint8_t>(width, height, random);
    expect_extremes<4, std::uint8_t>(width, height, random);
    expect_extremes<4, float>(width, height, random);
  }
}

}  // namespace
