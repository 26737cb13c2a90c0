// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/plane_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dot/kernel/portable_kernels.hpp"
#include "support/random.hpp"

namespace {

using dot::Image;
using dot::PlaneFit;
using dot::test::Random;

bool fit_plane(const Image<float>& q, int u, int v, int radius, float start, float gate, int min_inliers,
               PlaneFit& fit) {
  const dot::kernel::PlaneSeed seed{u, v, start, gate};
  dot::portable_kernels().fit_planes(dot::kernel_view(q.view()), dot::plane_window(radius, min_inliers), &seed, 1,
                                     &fit);
  return fit.inliers > 0;
}

/// The depths of an image that may be used.
template <typename May>
Image<float> where(const Image<float>& q, May&& may) {
  dot::Image<std::uint8_t> mask(41, 31);
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; ++x) mask(x, y) = may(x, y) ? 255 : 0;
  Image<float> surface;
  dot::cut_surface(q.view(), mask.view(), 0, 1e9f, surface);
  return surface;
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
  ASSERT_TRUE(fit_plane(q, 20, 15, 5, 0.2f, 0.01f, 30, fit));
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_NEAR(fit.du, 0.001, 1e-7);
  EXPECT_NEAR(fit.dv, -0.002, 1e-7);
  EXPECT_LT(fit.variance, 1e-12);
  EXPECT_EQ(fit.inliers, 121);
}

TEST(PlaneFit, FindsASteepPlaneFromItsCentre) {
  // The corners are 0.015 off the centre: one and a half gates, within the first pass's three.
  const Image<float> q = plane_image();
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q, 20, 15, 5, 0.204f, 0.01f, 30, fit));
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_EQ(fit.inliers, 121);
}

TEST(PlaneFit, IsCutOffAtTheImageBorder) {
  const Image<float> q = plane_image();
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q, 0, 30, 4, plane(0, 30), 0.01f, 20, fit));
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
    ASSERT_TRUE(fit_plane(q, 20, 15, 5, 0.2f, gate, 40, fit));
    // 4 sigma of a mean of the 85 that are left, and as much again for the outliers that happen to lie in the gate.
    EXPECT_NEAR(fit.q, 0.2, 8 * sigma / std::sqrt(85.f));
    EXPECT_NEAR(fit.du, 0.001, 8 * sigma / std::sqrt(85.f) / 3.2f);  // 3.2 px: spread of the columns
    EXPECT_NEAR(fit.dv, -0.002, 8 * sigma / std::sqrt(85.f) / 3.2f);
    EXPECT_GT(fit.inliers, 60);
    EXPECT_LT(fit.variance, 3.2f * sigma * sigma);
  }
}

TEST(PlaneFit, StaysOnTheSurfaceItStartsFrom) {
  // A nearer surface covers 40 % of the window.
  Image<float> q = plane_image();
  for (int y = 0; y < 31; ++y)
    for (int x = 22; x < 41; ++x) q(x, y) = 0.5f;
  PlaneFit fit;
  ASSERT_TRUE(fit_plane(q, 20, 15, 5, 0.2f, 0.01f, 30, fit));
  EXPECT_EQ(fit.inliers, 77);
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  ASSERT_TRUE(fit_plane(q, 20, 15, 5, 0.5f, 0.01f, 30, fit));
  EXPECT_EQ(fit.inliers, 44);
  EXPECT_NEAR(fit.q, 0.5, 1e-5);
  EXPECT_NEAR(fit.du, 0, 1e-6);
}

TEST(PlaneFit, UsesOnlyWhatIsAccepted) {
  Image<float> q = plane_image();
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; x += 2) q(x, y) += 0.005f;  // inside the gate
  PlaneFit fit;
  const Image<float> odd = where(q, [](int x, int) { return x % 2 == 1; });
  ASSERT_TRUE(fit_plane(odd, 20, 15, 5, 0.2f, 0.02f, 30, fit));
  EXPECT_EQ(fit.inliers, 66);
  EXPECT_NEAR(fit.q, 0.2, 1e-6);
  EXPECT_LT(fit.variance, 1e-12);
}

// Of windows over 14 pixels not all rows are read; those that are count for the others.
TEST(PlaneFit, WindowsMayBeWiderThanTheImage) {
  const Image<float> q = plane_image();
  for (const int radius : {8, 15, 16, 100}) {
    PlaneFit fit;
    ASSERT_TRUE(fit_plane(q, 22, 16, radius, 0.2f, 0.1f, 30, fit)) << radius;
    EXPECT_EQ(fit.inliers, std::min(2 * radius + 1, 22 + std::min(radius, 18) + 1 - std::max(22 - radius, 0)) *
                               (std::min(16 + radius, 30) + 1 - std::max(16 - radius, 0)));
    EXPECT_NEAR(fit.q, plane(22, 16), 1e-6);
    EXPECT_NEAR(fit.du, 0.001, 1e-7);
    EXPECT_NEAR(fit.dv, -0.002, 1e-7);
  }
}

TEST(PlaneFit, ASurfaceIsOfItsMaskAndRange) {
  Image<float> q = plane_image();
  q(3, 3) = 0, q(4, 4) = -0.2f, q(5, 5) = std::numeric_limits<float>::infinity();
  q(6, 6) = std::numeric_limits<float>::quiet_NaN();
  dot::Image<std::uint8_t> mask(41, 31);
  for (int y = 0; y < 31; ++y)
    for (int x = 0; x < 41; ++x) mask(x, y) = x < 30 ? 1 : 0;
  Image<float> surface;
  for (const float q_min : {-1.f, 0.19f}) {
    dot::cut_surface(q.view(), mask.view(), q_min, 0.21f, surface);
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 41; ++x) {
        const bool of_it = x < 30 && q(x, y) > 0 && q(x, y) >= q_min && q(x, y) <= 0.21f;
        EXPECT_EQ(surface(x, y), of_it ? q(x, y) : 0) << x << ", " << y;
      }
  }
}

TEST(PlaneFit, RejectsTooFew) {
  Image<float> q = plane_image();
  PlaneFit fit;
  EXPECT_TRUE(fit_plane(q, 20, 15, 5, 0.2f, 0.01f, 121, fit));
  q(17, 12) = 0;
  EXPECT_FALSE(fit_plane(q, 20, 15, 5, 0.2f, 0.01f, 121, fit));
  EXPECT_FALSE(fit_plane(q, 20, 15, 5, 0.9f, 0.01f, 30, fit));  // nothing at that depth
  const Image<float> corner = where(q, [](int x, int y) { return x < 20 && y < 12; });
  EXPECT_FALSE(fit_plane(corner, 20, 15, 5, 0.2f, 0.01f, 30, fit));
  q.fill(0);
  EXPECT_FALSE(fit_plane(q, 20, 15, 5, 0.2f, 0.01f, 30, fit));
}

TEST(PlaneFit, RejectsALine) {
  const Image<float> q = plane_image();
  PlaneFit fit;
  const Image<float> upright = where(q, [](int x, int) { return x == 20; });
  const Image<float> diagonal = where(q, [](int x, int y) { return x - 20 == y - 15; });
  EXPECT_FALSE(fit_plane(upright, 20, 15, 5, 0.2f, 0.02f, 5, fit));
  EXPECT_FALSE(fit_plane(diagonal, 20, 15, 5, 0.2f, 0.02f, 5, fit));
}

}  // namespace
