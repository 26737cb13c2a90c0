// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/scale_jitter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "support/random.hpp"

namespace {

using dot::ScaleJitter;
using dot::test::Random;

/// Sigma that is learnt from `frames` frames of 40 patches. @param log_scale of each frame's depth. @param sigma of a
/// patch's ratio.
double learnt(int frames, double sigma, Random& random, const std::function<double(int)>& log_scale) {
  ScaleJitter jitter;
  double before = log_scale(0);
  for (int i = 1; i <= frames; ++i) {
    const double now = log_scale(i);
    std::vector<float> ratios(40);
    for (float& r : ratios) r = static_cast<float>(std::exp(now - before) - 1 + sigma * random.normal());
    jitter.add(ratios);
    before = now;
  }
  return std::sqrt(jitter.variance());
}

TEST(ScaleJitter, IsTheSigmaOfScalesThatAreIndependent) {
  Random random(3);
  for (const double sigma : {0.005, 0.02, 0.05}) {
    double mean = 0;
    constexpr int kTimes = 20;
    for (int i = 0; i < kTimes; ++i)
      mean += learnt(60, 0.005, random, [&](int) { return sigma * random.normal(); }) / kTimes;
    EXPECT_NEAR(mean, sigma, 0.15 * sigma);
  }
}

TEST(ScaleJitter, IsNoneWhereOnlyPatchesAreNoisy) {
  Random random(5);
  double mean = 0;
  constexpr int kTimes = 20;
  for (int i = 0; i < kTimes; ++i) mean += learnt(60, 0.01, random, [](int) { return 0.0; }) / kTimes;
  EXPECT_LT(mean, 0.003);
}

// A bias of stereo makes the depth of what comes nearer change by more than its motion, in each frame.
TEST(ScaleJitter, IsNoneOfASteadyChange) {
  Random random(7);
  EXPECT_LT(learnt(60, 0.0001, random, [](int i) { return 0.002 * i; }), 0.0005);
}

TEST(ScaleJitter, IsToldByTheFirstFactor) {
  Random random(11);
  double squares = 0;
  constexpr int kTimes = 400;
  for (int i = 0; i < kTimes; ++i) {
    const double sigma = learnt(1, 0.002, random, [&](int) { return 0.02 * random.normal(); });
    squares += sigma * sigma / kTimes;
  }
  EXPECT_NEAR(std::sqrt(squares), 0.02, 0.002);
}

TEST(ScaleJitter, IsNotKnownFromFewPatches) {
  ScaleJitter jitter;
  for (int i = 0; i < 20; ++i) {
    std::vector<float> few(ScaleJitter::kLeastPatches - 1, i % 2 ? 0.1f : -0.1f);
    jitter.add(few);
  }
  EXPECT_EQ(jitter.variance(), 0);
}

}  // namespace
