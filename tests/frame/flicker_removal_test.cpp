// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/flicker_removal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/synthetic_scene.hpp"

namespace {

using dot::FlickerRemoval;
using Grey = dot::Image<std::uint8_t>;

constexpr int kWidth = 320, kHeight = 240;

/// A texture that has moved down by some pixels.
Grey scene(double down = 0, int height = kHeight) {
  const dot::test::Texture texture(3, 8, 60, 40);
  Grey grey(kWidth, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < kWidth; ++x)
      grey(x, y) = static_cast<std::uint8_t>(std::clamp(texture(x, y - down), 0.0, 255.0));
  return grey;
}

/// Brightness of row y, which differs from frame to frame.
double light(int frame, int y, double amplitude, double periods) {
  return 1 + amplitude * std::sin(6.283185307179586 * (periods * y / kHeight + 0.37 * frame));
}

Grey lit(Grey grey, int frame, double amplitude, double periods = 2.7) {
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < grey.width(); ++x)
      grey(x, y) =
          static_cast<std::uint8_t>(std::clamp(grey(x, y) * light(frame, y, amplitude, periods) + 0.5, 0.0, 255.0));
  return grey;
}

/// Hands an image over. @return it without its bands, or nothing if there are none.
Grey removed(FlickerRemoval& removal, Grey grey, bool follows = true) {
  dot::Pyramid pyramid;
  pyramid.build(grey.view(), 3);
  if (!removal.compare(pyramid, follows)) return {};
  for (int y = 0; y < grey.height(); ++y) removal.correct(y, grey.height(), grey.row(y), grey.width());
  return grey;
}

/// Logarithm of the light that a row of an image has, about each tenth row.
std::vector<double> rows_of(const Grey& image, const Grey& scene) {
  std::vector<double> rows;
  for (int y = 5; y < scene.height(); y += 10) {
    std::vector<double> ratios{};
    for (int x = 0; x < scene.width(); ++x)
      if (scene(x, y) > 40 && scene(x, y) < 180) ratios.push_back(std::log(1.0 * image(x, y) / scene(x, y)));
    rows.push_back(ratios.empty() ? 0 : dot::median(ratios.begin(), ratios.end()));
  }
  return rows;
}

/// Largest difference of two images' light in any row, after that of the whole images.
double difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  std::vector<double> sorted = a;
  const double middle = dot::median(sorted.begin(), sorted.end());
  double worst = 0;
  for (const double d : a) worst = std::max(worst, std::abs(d - middle));
  return worst;
}

TEST(FlickerRemoval, BringsEachImageToTheLightOfTheOneBefore) {
  FlickerRemoval removal;
  EXPECT_TRUE(removed(removal, lit(scene(), 0, 0.15), false).empty());
  std::vector<double> before = rows_of(lit(scene(), 0, 0.15), scene()), raw_before = before;
  for (int frame = 1; frame < 12; ++frame) {
    const Grey moved = scene(1.5 * frame), raw = lit(moved, frame, 0.15), corrected = removed(removal, raw);
    ASSERT_FALSE(corrected.empty()) << "frame " << frame;
    const std::vector<double> rows = rows_of(corrected, moved), raw_rows = rows_of(raw, moved);
    const double raw_bands = difference(raw_rows, raw_before);
    EXPECT_GT(raw_bands, 0.2) << "frame " << frame;
    EXPECT_LT(difference(rows, before), raw_bands / 4) << "frame " << frame;
    before = rows, raw_before = raw_rows;
  }
}

TEST(FlickerRemoval, LeavesSteadyLightAlone) {
  FlickerRemoval removal;
  for (int frame = 0; frame < 10; ++frame) {
    const double jolt = frame % 3 == 0 ? 12 : 0;
    EXPECT_TRUE(removed(removal, scene(4 * frame + jolt), frame > 0).empty()) << "frame " << frame;
  }
}

TEST(FlickerRemoval, ExposureIsNoBand) {
  FlickerRemoval removal;
  removed(removal, scene(), false);
  Grey dark = scene();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) dark(x, y) = static_cast<std::uint8_t>(0.6 * dark(x, y));
  EXPECT_TRUE(removed(removal, dark).empty());
}

TEST(FlickerRemoval, AnImageThatComesAgainIsTheSame) {
  FlickerRemoval removal;
  removed(removal, lit(scene(), 0, 0.15), false);
  const Grey raw = lit(scene(2), 1, 0.15), once = removed(removal, raw), again = removed(removal, raw);
  ASSERT_FALSE(once.empty());
  ASSERT_FALSE(again.empty());
  EXPECT_TRUE(std::equal(once.row(0), once.row(0) + kWidth * kHeight, again.row(0)));
}

TEST(FlickerRemoval, SaturatedPixelsStay) {
  FlickerRemoval removal;
  const auto with_lamp = [](Grey grey) {
    for (int y = 0; y < kHeight; ++y) std::fill_n(grey.row(y) + 100, 20, std::uint8_t{255});
    return grey;
  };
  removed(removal, with_lamp(lit(scene(), 0, 0.15)), false);
  const Grey corrected = removed(removal, with_lamp(lit(scene(), 1, 0.15)));
  ASSERT_FALSE(corrected.empty());
  for (int y = 0; y < kHeight; ++y) EXPECT_EQ(corrected(110, y), 255) << "row " << y;
}

TEST(FlickerRemoval, ASwitchedOffLampIsForgotten) {
  FlickerRemoval removal;
  int frame = 0;
  removed(removal, lit(scene(), frame++, 0.15), false);
  for (; frame < 6; ++frame) ASSERT_FALSE(removed(removal, lit(scene(), frame, 0.15)).empty());
  int corrected = 0;
  for (; frame < 100; ++frame) corrected += !removed(removal, scene(0.1 * frame)).empty();
  EXPECT_GT(corrected, 5) << "the frames after it are still compared with those before";
  EXPECT_LT(corrected, 90);
  EXPECT_TRUE(removed(removal, scene(0.1 * frame)).empty());
}

TEST(FlickerRemoval, OtherLampsAreFound) {
  FlickerRemoval removal;
  int frame = 0;
  removed(removal, lit(scene(), frame++, 0.15), false);
  for (; frame < 6; ++frame) ASSERT_FALSE(removed(removal, lit(scene(), frame, 0.15)).empty());
  for (; frame < 100; ++frame) removed(removal, scene(0.1 * frame));
  removed(removal, lit(scene(), frame++, 0.15, 5.2));
  EXPECT_FALSE(removed(removal, lit(scene(), frame, 0.15, 5.2)).empty());
}

// Twelve of the sixteen columns of cells are saturated, or black with an offset of the sensor.
TEST(FlickerRemoval, CellsWithoutAMeasuredBrightnessDoNotCount) {
  for (const int value : {255, 8}) {
    const auto covered = [value](Grey grey) {
      for (int y = 0; y < kHeight; ++y) std::fill_n(grey.row(y) + 80, 240, static_cast<std::uint8_t>(value));
      return grey;
    };
    FlickerRemoval removal;
    removed(removal, covered(lit(scene(), 0, 0.15)), false);
    EXPECT_FALSE(removed(removal, covered(lit(scene(), 1, 0.15))).empty()) << "grey value " << value;
  }
}

TEST(FlickerRemoval, AFrameThatFollowsNoneStartsAnew) {
  FlickerRemoval removal;
  removed(removal, lit(scene(), 0, 0.15), false);
  ASSERT_FALSE(removed(removal, lit(scene(), 1, 0.15)).empty());
  EXPECT_TRUE(removed(removal, lit(scene(), 2, 0.15), false).empty());
  EXPECT_FALSE(removed(removal, lit(scene(), 3, 0.15)).empty());
}

TEST(FlickerRemoval, TooFewRowsAreLeftAlone) {
  FlickerRemoval removal;
  for (int frame = 0; frame < 3; ++frame)
    EXPECT_TRUE(removed(removal, lit(scene(0, 40), frame, 0.3), frame > 0).empty());
}

}  // namespace
