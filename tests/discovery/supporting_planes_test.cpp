// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/supporting_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random.hpp"

namespace {

using dot::Image;
using dot::Intrinsics;
using dot::SupportingPlanes;

constexpr int width = 160, height = 120;
constexpr float sigma = 0.0005f;
const Intrinsics camera{100, 100, 79.5, 59.5, width, height, 0};

/// Ground 2 m below the camera up to a wall 20 m ahead, with noise; 1/m.
Image<float> yard(double noise = sigma) {
  dot::test::Random random(7);
  Image<float> q(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      q(x, y) = static_cast<float>(std::max((y - camera.cy) / camera.fy / 2, 0.05) + random.normal(noise));
  return q;
}

/// A box whose front is at inverse depth `box_q`.
void put(Image<float>& q, int x0, int y0, int x1, int y1, float box_q) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) q(x, y) = box_q;
}

SupportingPlanes found(const Image<float>& q) {
  SupportingPlanes planes;
  planes.find(
      q, camera, [](float) { return sigma; }, [](int, int) { return true; });
  return planes;
}

TEST(SupportingPlanes, HoldGroundAndWall) {
  const Image<float> q = yard();
  const SupportingPlanes planes = found(q);
  EXPECT_EQ(planes.count(), 2);
  int held = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) held += planes.hold(x, y, q(x, y), sigma);
  EXPECT_GT(held, 0.99 * width * height);
}

TEST(SupportingPlanes, DoNotHoldWhatStandsOnThem) {
  Image<float> q = yard();
  put(q, 60, 50, 100, 79, 0.1f);  // 10 m away, from above the camera's height down to the ground
  const SupportingPlanes planes = found(q);
  for (int y = 52; y < 75; ++y) EXPECT_FALSE(planes.hold(80, y, q(80, y), sigma)) << y;
  EXPECT_TRUE(planes.hold(80, 79, 0.1f, sigma));  // a tenth of the camera's height above the ground
  EXPECT_TRUE(planes.hold(80, 110, q(80, 110), sigma));
}

TEST(SupportingPlanes, RiseIsThatOfTheNearestPlane) {
  const SupportingPlanes planes = found(yard());
  // 0.2 m is a tenth of the distance of the ground; the wall at 20 m holds no more than that either.
  EXPECT_TRUE(planes.hold(80, 20, 1 / 19.9f, sigma));
  EXPECT_FALSE(planes.hold(80, 20, 1 / 19.0f, sigma));
}

// A car is 1.5 m high, and a tenth of the height from which a drone looks down.
TEST(SupportingPlanes, FromTheAirDoNotHoldACar) {
  dot::test::Random random(9);
  Image<float> q(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) q(x, y) = static_cast<float>(1 / 15.0 + random.normal(sigma));
  put(q, 70, 50, 90, 60, 1 / 13.7f);
  const SupportingPlanes planes = found(q);
  EXPECT_EQ(planes.count(), 1);
  EXPECT_FALSE(planes.hold(80, 55, q(80, 55), sigma));
  EXPECT_TRUE(planes.hold(30, 55, 1 / 14.8f, sigma));  // a kerb
}

// The side of a large thing has much behind it.
TEST(SupportingPlanes, LargeThingIsNone) {
  Image<float> q = yard();
  put(q, 40, 0, 150, 75, 0.125f);
  const SupportingPlanes planes = found(q);
  EXPECT_FALSE(planes.hold(70, 40, 0.125f, sigma));
  EXPECT_TRUE(planes.hold(70, 110, q(70, 110), sigma));
}

TEST(SupportingPlanes, NoneWithoutMeasurements) {
  Image<float> q(width, height);
  q.fill(0);
  const SupportingPlanes planes = found(q);
  EXPECT_EQ(planes.count(), 0);
  EXPECT_FALSE(planes.hold(80, 100, 0.2f, sigma));
}

}  // namespace
