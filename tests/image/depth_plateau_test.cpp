// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/depth_plateau.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace {

using dot::DepthPlateau;
using dot::ImageRef;
using dot::PixelFormat;

constexpr int kWidth = 320, kHeight = 240;

/// Metres by row and column.
using Scene = std::function<double(int x, int y)>;

/// Ground under the horizon in the middle, from 2 m on; above it a hill, 20 m to 140 m away; noise of 2 %.
Scene landscape() {
  return [random = dot::test::Random(3)](int x, int y) mutable {
    const double z = y > kHeight / 2 ? 240.0 / (y - kHeight / 2) : 20.0 + 0.6 * (kHeight / 2 - y) + 0.15 * x;
    return z * (1 + random.normal(0.02));
  };
}

/// What is farther than the type can say has its largest value.
template <typename Value>
std::vector<Value> image_of(const Scene& scene, double unit) {
  std::vector<Value> values;
  const double largest = std::numeric_limits<Value>::max();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) values.push_back(static_cast<Value>(std::min(unit * scene(x, y), largest)));
  return values;
}

template <typename Value>
ImageRef ref_to(const std::vector<Value>& values, double unit) {
  constexpr bool words = sizeof(Value) == 2;
  return {values.data(),
          kWidth,
          kHeight,
          kWidth * static_cast<int>(sizeof(Value)),
          words ? PixelFormat::DepthU16 : PixelFormat::DepthF32,
          unit};
}

DepthPlateau floats(const Scene& scene, double max_depth = 400, double known = 0) {
  const auto values = image_of<float>(scene, 1);
  return dot::find_plateau(ref_to(values, 1), max_depth, known);
}
DepthPlateau words(const Scene& scene, double unit, double max_depth = 400) {
  const auto values = image_of<std::uint16_t>(scene, unit);
  return dot::find_plateau(ref_to(values, unit), max_depth);
}

Scene cut_off(double farthest) {
  return [farthest, scene = landscape()](int x, int y) { return std::min(farthest, scene(x, y)); };
}

TEST(DepthPlateau, IsFoundWhereDepthIsCutOff) {
  for (const double farthest : {10.0, 25.0, 60.0}) {
    const DepthPlateau plateau = floats(cut_off(farthest));
    EXPECT_TRUE(plateau.is_flat) << farthest;
    EXPECT_EQ(plateau.depth, farthest);
    int beyond = 0;
    Scene scene = landscape();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) beyond += scene(x, y) >= farthest;
    EXPECT_NEAR(plateau.share, static_cast<double>(beyond) / (kWidth * kHeight), 0.02) << farthest;
    for (const double unit : {256.0, 1000.0}) {
      EXPECT_TRUE(words(cut_off(farthest), unit).is_flat) << farthest << ' ' << unit;
      EXPECT_DOUBLE_EQ(words(cut_off(farthest), unit).depth, farthest) << unit;
    }
  }
}

TEST(DepthPlateau, IsNotInGoodDepth) {
  EXPECT_FALSE(floats(landscape()).is_flat);
  EXPECT_FALSE(words(landscape(), 256).is_flat);
  EXPECT_FALSE(floats([](int, int) { return 0.0; }).is_flat);
  EXPECT_EQ(floats([](int, int) { return 0.0; }).depth, 0);
}

TEST(DepthPlateau, IsMadeOfHolesToo) {
  const auto with_holes = [scene = landscape()](int x, int y) { return x < 60 ? 300.0 : scene(x, y); };
  EXPECT_TRUE(floats(with_holes).is_flat);
  EXPECT_EQ(floats(with_holes).depth, 300);
  EXPECT_FALSE(floats(with_holes, 300).is_flat) << "not measured anyway";
  EXPECT_FALSE(words(with_holes, 256).is_flat) << "written as 65535, which is no measurement";
  EXPECT_LT(words(with_holes, 256).depth, 200);
}

TEST(DepthPlateau, IsNotEverything) {
  EXPECT_FALSE(floats([](int, int) { return 5.0; }).is_flat);
  EXPECT_FALSE(floats([](int x, int) { return x < 20 ? 4.0 + 0.01 * x : 5.0; }).is_flat) << "nearly all";
  EXPECT_FALSE(floats([](int x, int y) { return x < 100 && y > 100 ? 3.0 : 5.0; }).is_flat) << "a flat scene";
}

TEST(DepthPlateau, IsNotAFewPixels) {
  const auto few = [scene = landscape()](int x, int y) { return x < 2 ? 150.0 : scene(x, y); };
  EXPECT_FALSE(floats(few).is_flat);
  const auto more = [scene = landscape()](int x, int y) { return x < 6 ? 150.0 : scene(x, y); };
  EXPECT_TRUE(floats(more).is_flat);
}

// A wall whose pixels differ by the least step of its depth, and slanted ground near the end of the depth.
TEST(DepthPlateau, IsMoreThanWhatIsNear) {
  dot::test::Random random(5);
  EXPECT_FALSE(
      words([&](int x, int y) { return y > 180 ? 3 + 0.01 * x : 8 + 1e-3 * std::round(random.normal(0.8)); }, 1000)
          .is_flat);
  EXPECT_FALSE(floats([](int x, int y) { return x < 40 ? 20.0 : 18.1 + 1e-3 * x + 1e-5 * y; }).is_flat);
}

// Where depth ends with holes, all of the last row of even ground has the same depth, without noise.
TEST(DepthPlateau, IsNotARow) {
  EXPECT_FALSE(floats([](int x, int y) { return y < 124 ? 0.0 : 800.0 / (y - 120) - (x == 5 ? 1e-4 : 0); }).is_flat);
}

TEST(DepthPlateau, IsNotACoarseStep) {
  const Scene scene = landscape();
  for (const double step : {0.1, 0.5, 2.0})
    EXPECT_FALSE(floats([&](int x, int y) { return step * std::round(scene(x, y) / step); }).is_flat) << step;
  const double focal_baseline = 160;  // whole disparities, the last ones of much of the picture
  const DepthPlateau plateau =
      floats([&](int x, int y) { return focal_baseline / std::max(1.0, std::round(focal_baseline / scene(x, y))); });
  EXPECT_EQ(plateau.depth, 160);
  EXPECT_FALSE(plateau.is_flat);
}

TEST(DepthPlateau, IsSeenAmongValuesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto scene = [&, depth = cut_off(30)](int x, int y) {
    if (x % 9 == 1) return nan;
    if (x % 9 == 2) return infinity;
    if (x % 9 == 3) return -infinity;
    return x % 9 == 4 ? -2.0 : depth(x, y);
  };
  EXPECT_TRUE(floats(scene).is_flat);
  EXPECT_EQ(floats(scene).depth, 30);
}

TEST(DepthPlateau, IsTakenFromBefore) {
  EXPECT_TRUE(floats([](int, int) { return 5.0; }, 400, 5).is_flat);
  EXPECT_FALSE(floats([](int, int) { return 5.0; }, 400, 6).is_flat);
}

TEST(DepthPlateau, TakesImagesOfAFewPixels) {
  const std::vector<float> metres{1, 2, 2};
  const DepthPlateau plateau = dot::find_plateau({metres.data(), 3, 1, 12, PixelFormat::DepthF32}, 400);
  EXPECT_EQ(plateau.depth, 2);
  EXPECT_NEAR(plateau.share, 2.0 / 3, 1e-9);
}

}  // namespace
