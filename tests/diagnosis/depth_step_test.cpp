// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/diagnosis/depth_step.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "support/random.hpp"

namespace {

using dot::DepthStep;
using dot::Image;
using dot::test::Random;

constexpr float kLeastJump = 0.01f;

/// A dark wall and bright posts before it, which move by 3 to 19 pixels a frame, as farther and nearer ones do.
struct Posts {
  int width = 203, height = 480;
  int hole_every = 0;  ///< each so-many-th pixel has no depth; 0: all have

  static bool is_post(int x, int y, int frame) {
    return (x + (3 + 4 * (y / DepthStep::kRowStep % 5)) * frame) % 67 < 21;
  }
  Image<std::uint8_t> image(int frame) const {
    Image<std::uint8_t> out(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) out(x, y) = is_post(x, y, frame) ? 180 : 60;
    return out;
  }
  Image<float> depth(int frame) const {
    Image<float> out(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        out(x, y) = hole_every > 0 && x % hole_every == 0 ? 0.0f : is_post(x, y, frame) ? 0.2f : 0.1f;
    return out;
  }
};

#if defined(__GNUC__)
#define DOT_TEST_NOINLINE __attribute__((noinline))
#else
#define DOT_TEST_NOINLINE
#endif

/// Leaves numbers where the next function has its variables.
DOT_TEST_NOINLINE void fill_stack(double value) {
  volatile double numbers[200];
  for (volatile double& number : numbers) number = value;
}

DOT_TEST_NOINLINE int lag_of(const DepthStep& step) { return step.lag(); }

int lag_found(const Posts& posts, int lag) {
  DepthStep step;
  for (int frame = 10; frame < 40; ++frame) step.add(posts.image(frame), posts.depth(frame - lag), kLeastJump);
  fill_stack(1e300);
  return lag_of(step);
}

TEST(DepthStep, TellsByHowManyFramesTheDepthIsLate) {
  for (const int hole_every : {0, 3, 29}) {
    Posts posts;
    posts.hole_every = hole_every;
    for (int lag = -DepthStep::kMaxLag; lag <= DepthStep::kMaxLag; ++lag)
      EXPECT_EQ(lag_found(posts, lag), lag) << "a hole every " << hole_every;
  }
}

TEST(DepthStep, TellsNothingOfThingsThatRest) {
  DepthStep step;
  const Posts posts;
  for (int frame = 0; frame < 40; ++frame) step.add(posts.image(0), posts.depth(0), kLeastJump);
  EXPECT_EQ(step.lag(), 0);
}

/// Expects the counts of an image with depth 0.1 and 0.3 by turns. @param holes share of the pixels without depth.
void expect_counts(int width, double holes, float least_jump) {
  constexpr int kHeight = 64;
  Random random(1);
  Image<std::uint8_t> image(width, kHeight);
  image.fill(100);
  Image<float> depth(width, kHeight);
  int pixels = 0, measured = 0;
  double sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < width; ++x) {
      const float q = random.uniform() < holes ? 0.0f : x / 23 % 2 == 0 ? 0.1f : 0.3f;
      depth(x, y) = q;
      if (y % DepthStep::kRowStep != DepthStep::kRowStep / 2) continue;
      ++pixels, measured += q > 0, sum += static_cast<double>(q);
    }
  DepthStep step;
  step.add(image, depth, least_jump);
  EXPECT_EQ(step.pixels(), pixels);
  EXPECT_EQ(step.measured(), measured) << width;
  EXPECT_NEAR(step.mean_inverse_depth(), sum / measured, 1e-6) << width;
}

// Rows are read in blocks, which end at steps, at holes and before the border.
TEST(DepthStep, CountsEachPixelThatHasDepth) {
  for (const int width : {60, 61, 64, 79, 96, 131})
    for (const double holes : {0.0, 0.02, 0.3}) {
      expect_counts(width, holes, kLeastJump);
      expect_counts(width, holes, 1);  // nothing is a step
    }
}

}  // namespace
