// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/plane_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dot/image/image.hpp"
#include "support/random.hpp"

namespace {

using dot::fit_plane;
using dot::Image;
using dot::PlaneFit;
using dot::test::Random;

const dot::DepthSupport everywhere;

/// Where the depth of the plane image may be used, as a mask of its size.
template <typename May>
dot::Image<std::uint8_t> where(May&& may) {
  dot::Image<std::uint8_t> mask(41, 31);
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; ++x) mask(x, y) = may(x, y) ? 255 : 0;
  return mask;
}

/// q = 0.2 + 0.001 (u - 20) - 0.002 (v - 15): a steep plane, 5 m away.
float plane(int x, int y) { return 0.2f + 0.001f * static_cast<float>(x - 20) - 0.002f * static_cast<float>(y - 15); }

Image<float> plane_image() {
  Image<float> q(41, 31);
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; ++x) q(x, y) = plane(x, y);
  return q;
}

TEST(PlaneFit, IsExactOnAPlane) {
  const Image<float> q = plane_image();
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 30, everywhere, fit));
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_NEAR(fit.du, 0.001, 1e-7);
  EXPECT_NEAR(fit.dv, -0.002, 1e-7);
  EXPECT_LT(fit.rms, 1e-6);
  EXPECT_EQ(fit.inliers, 121);
}

TEST(PlaneFit, FindsASteepPlaneFromItsCentre) {
  // The corners are 0.015 off the centre: one and a half gates, within the first pass's three.
  const Image<float> q = plane_image();
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.204f, 0.01f, 30, everywhere, fit));
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_EQ(fit.inliers, 121);
}

TEST(PlaneFit, IsCutOffAtTheImageBorder) {
  const Image<float> q = plane_image();
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q.view(), 0, 30, 4, plane(0, 30), 0.01f, 20, everywhere, fit));
  EXPECT_EQ(fit.inliers, 25);
  EXPECT_NEAR(fit.q, plane(0, 30), 1e-6);
  EXPECT_NEAR(fit.du, 0.001, 1e-7);
}

TEST(PlaneFit, WithstandsThirtyPercentOutliers) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const float sigma = 0.001f, gate = 5 * sigma;
    Image<float> q = plane_image();
    for (int y = 10; y <= 20; ++y)
      for (int x = 15; x <= 25; ++x) {
        q(x, y) += static_cast<float>(random.normal(sigma));
        // Anything from 15 cm to 200 m, or no depth at all.
        if (random.uniform() < 0.3)
          q(x, y) = random.uniform() < 0.3 ? 0.f : static_cast<float>(1 / random.uniform(0.15, 200));
      }
    PlaneFit fit;
    ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.2f, gate, 40, everywhere, fit));
    // 4 sigma of a mean of the 85 that are left, and as much again for the outliers that happen to lie in the gate.
    EXPECT_NEAR(fit.q, 0.2, 8 * sigma / std::sqrt(85.f));
    EXPECT_NEAR(fit.du, 0.001, 8 * sigma / std::sqrt(85.f) / 3.2f);  // 3.2 px: spread of the columns
    EXPECT_NEAR(fit.dv, -0.002, 8 * sigma / std::sqrt(85.f) / 3.2f);
    EXPECT_GT(fit.inliers, 60);
    EXPECT_LT(fit.rms, 1.8f * sigma);
  }
}

TEST(PlaneFit, StaysOnTheSurfaceItStartsFrom) {
  // A nearer surface covers 40 % of the window.
  Image<float> q = plane_image();
  for (int y = 0; y < 31; ++y)
    for (int x = 22; x < 41; ++x) q(x, y) = 0.5f;
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 30, everywhere, fit));
  EXPECT_EQ(fit.inliers, 77);
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.5f, 0.01f, 30, everywhere, fit));
  EXPECT_EQ(fit.inliers, 44);
  EXPECT_NEAR(fit.q, 0.5, 1e-5);
  EXPECT_NEAR(fit.du, 0, 1e-6);
}

TEST(PlaneFit, UsesOnlyWhatIsAccepted) {
  Image<float> q = plane_image();
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; x += 2) q(x, y) += 0.005f;  // inside the gate
  PlaneFit fit;
  const auto odd = where([](int x, int) { return x % 2 == 1; });
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.02f, 30, {odd.view()}, fit));
  EXPECT_EQ(fit.inliers, 66);
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_LT(fit.rms, 1e-6);
}

// A crop of a mask that reaches over the image's border, in a window wider than the image.
TEST(PlaneFit, AMaskMayLieAnywhere) {
  const Image<float> q = plane_image();
  dot::Image<std::uint8_t> crop(30, 20);
  crop.fill(255);
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 100, 0.2f, 0.1f, 30, {crop.view(), 25, -6}, fit));
  EXPECT_EQ(fit.inliers, 16 * 14);
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_NEAR(fit.du, 0.001, 1e-7);
  EXPECT_NEAR(fit.dv, -0.002, 1e-7);
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 100, 0.2f, 0.1f, 1, {crop.view(), 60, 0}, fit));
}

TEST(PlaneFit, UsesOnlyDepthsWithinTheRange) {
  Image<float> q = plane_image();
  for (int x = 0; x < 41; ++x) q(x, 15) = 0.201f;
  PlaneFit fit;
  dot::DepthSupport support;
  support.q_min = 0.1985f;
  support.q_max = 0.2015f;
  ASSERT_TRUE(fit_plane(q.view(), 20, 15, 1, 0.2f, 0.1f, 3, support, fit));
  EXPECT_EQ(fit.inliers, 5);
}

TEST(PlaneFit, RejectsTooFew) {
  Image<float> q = plane_image();
  PlaneFit fit;
  EXPECT_TRUE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 121, everywhere, fit));
  q(17, 12) = 0;
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 121, everywhere, fit));
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.9f, 0.01f, 30, everywhere, fit));  // nothing at that depth
  const auto corner = where([](int x, int y) { return x < 20 && y < 12; });
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 30, {corner.view()}, fit));
  q.fill(0);
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.01f, 30, everywhere, fit));
}

TEST(PlaneFit, RejectsALine) {
  const Image<float> q = plane_image();
  PlaneFit fit;
  const auto upright = where([](int x, int) { return x == 20; });
  const auto diagonal = where([](int x, int y) { return x - 20 == y - 15; });
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.02f, 5, {upright.view()}, fit));
  EXPECT_FALSE(fit_plane(q.view(), 20, 15, 5, 0.2f, 0.02f, 5, {diagonal.view()}, fit));
}

}  // namespace
