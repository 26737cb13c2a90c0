// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/depth_saturation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using dot::DepthSaturation;
using dot::SE3d;

constexpr int kWidth = 200, kHeight = 96;

/// Ground from 3 m on that ends at a wall, or goes on to 100 m.
/// @param wall metres. @param nearest metres, below it all is at the end of the depth.
std::vector<float> ground_and(double wall, double nearest = 3) {
  std::vector<float> metres;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      metres.push_back(static_cast<float>(std::min(wall, nearest * kHeight / (kHeight - y - 0.5 + 0.004 * x))));
  return metres;
}

double look(DepthSaturation& saturation, const std::vector<float>& metres) {
  return saturation.update({metres.data(), kWidth, kHeight, kWidth * 4, dot::PixelFormat::DepthF32}, 400);
}
double look_at_words(DepthSaturation& saturation, const std::vector<float>& metres) {
  std::vector<std::uint16_t> words;
  for (const float z : metres) words.push_back(static_cast<std::uint16_t>(z * 1000));
  return saturation.update({words.data(), kWidth, kHeight, kWidth * 2, dot::PixelFormat::DepthU16, 1000}, 400);
}

const SE3d kForwards = SE3d::translation({0, 0, -0.2}), kSideways = SE3d::translation({0.3, 0, 0});
const SE3d kTurn = SE3d::exp((dot::Vector6<double>() << 0, 0, 0, 0, 0.05, 0).finished());

TEST(DepthSaturation, LeavesOutAPlateauFromTheFirstFrameOn) {
  for (const SE3d& motion : {kForwards, kTurn}) {
    DepthSaturation of_floats, of_words;
    for (int i = 0; i < 30; ++i) {
      const auto metres = ground_and(15, 3 + 0.05 * i);
      EXPECT_EQ(look(of_floats, metres), 15) << i;
      EXPECT_EQ(look_at_words(of_words, metres), 15) << i;
      EXPECT_GT(of_floats.share(), 0.1);
      if (i == 0) of_floats.forget_motion(), of_words.forget_motion();
      if (i > 0) of_floats.moved(motion), of_words.moved(motion);
    }
  }
}

// The camera would have seen another depth of a wall.
TEST(DepthSaturation, IsNoWallThatComesNearer) {
  DepthSaturation saturation;
  EXPECT_EQ(look(saturation, ground_and(15)), 15) << "looks the same";
  for (int i = 1; i < 10; ++i) {
    saturation.moved(kForwards);
    EXPECT_GT(look(saturation, ground_and(15 - 0.2 * i)), 400) << i;
    EXPECT_EQ(saturation.share(), 0) << i;
  }
}

TEST(DepthSaturation, IsNoWallBesideAStandingCamera) {
  for (const SE3d& motion : {SE3d{}, kSideways}) {
    DepthSaturation saturation;
    int left_out = 0;
    for (int i = 0; i < 50; ++i) {
      left_out += look(saturation, ground_and(15)) < 400;
      saturation.moved(motion);
    }
    EXPECT_EQ(left_out, 3);
    // Which it is shows when the camera moves.
    saturation.moved(kForwards);
    EXPECT_EQ(look(saturation, ground_and(15)), 15);
  }
}

// Without the floor under it a camera may have nothing to find its motion by.
TEST(DepthSaturation, IsNotSuspectedForLongWhereTheMotionIsUnknown) {
  DepthSaturation saturation;
  int left_out = 0;
  for (int i = 0; i < 20; ++i) left_out += look(saturation, ground_and(15)) < 400, saturation.forget_motion();
  EXPECT_EQ(left_out, 3);
}

TEST(DepthSaturation, IsSuspectedOnlyOnce) {
  DepthSaturation saturation;
  for (int i = 0; i < 3; ++i) look(saturation, ground_and(15 - i)), saturation.moved(kSideways);
  EXPECT_GT(look(saturation, ground_and(8)), 400);
  saturation.moved(kForwards);  // before the frame after it
  EXPECT_GT(look(saturation, ground_and(8)), 400);
  saturation.moved(kForwards);
  EXPECT_EQ(look(saturation, ground_and(8)), 8);
}

/// A frame after which it is certain that the depth ends at 15 m.
DepthSaturation certain() {
  DepthSaturation saturation;
  for (int i = 0; i < 3; ++i) look(saturation, ground_and(15)), saturation.moved(kForwards);
  return saturation;
}

TEST(DepthSaturation, IsRemembered) {
  DepthSaturation saturation = certain();
  EXPECT_EQ(look(saturation, ground_and(10)), 15) << "a wall before the end of the depth";
  EXPECT_EQ(saturation.share(), 0);
  EXPECT_EQ(look(saturation, std::vector<float>(kWidth * kHeight, 0.f)), 15) << "a frame without depth";
  auto few = ground_and(10);
  for (std::size_t i = 0; i < few.size(); i += 200) few[i] = 15;
  EXPECT_EQ(look(saturation, few), 15);
  EXPECT_NEAR(saturation.share(), 0.005, 1e-6) << "too few to be found";
}

TEST(DepthSaturation, IsForgottenWhereDepthGoesOn) {
  DepthSaturation saturation = certain();
  EXPECT_GT(look(saturation, ground_and(200)), 400);
  EXPECT_GT(look(saturation, ground_and(15)), 400) << "not certain any more";
}

TEST(DepthSaturation, IsForgottenOnRequest) {
  DepthSaturation saturation = certain();
  saturation.forget();
  EXPECT_EQ(saturation.share(), 0);
  EXPECT_GT(look(saturation, ground_and(200)), 400);
  EXPECT_EQ(look(saturation, ground_and(12)), 12) << "suspected like the first one";
}

}  // namespace
