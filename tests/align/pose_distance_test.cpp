// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#include "dot/align/pose_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/synthetic_scene.hpp"

namespace {

using dot::Pinhole;
using dot::PointSet;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;

const Pinhole camera(dot::test::small_camera());

/// In rows over the image, every third of them near.
PointSet points_at(double near, double far) {
  PointSet points;
  int i = 0;
  for (int v = 20; v < camera.height(); v += 20)
    for (int u = 20; u < camera.width(); u += 20) {
      const auto ray = camera.unproject(dot::Vector2<double>(u, v));
      points.push(static_cast<float>(u), static_cast<float>(v), static_cast<float>(ray.x()),
                  static_cast<float>(ray.y()), static_cast<float>(1 / (i++ % 3 ? far : near)), 0.f);
    }
  return points;
}

SE3d forward(double metres) { return SE3d::translation(Vector3<double>(0, 0, -metres)); }

TEST(PoseDistance, OfAShiftIsThatInTheImage) {
  const SE3d shifted = SE3d::translation(Vector3<double>(0.1, 0, 0));
  EXPECT_NEAR(pose_distance(points_at(5, 5), camera, SE3d{}, shifted), 200 * 0.1 / 5, 1e-5);
}

TEST(PoseDistance, PointsOutOfSightUnderBothDoNotCount) {
  EXPECT_NEAR(pose_distance(points_at(3, 20), camera, forward(5), forward(5)), 0, 1e-9);
  // What is 20 m away is 15 m away then, and keeps its place but for the step: 15 / 14.9 - 1 of at most 200 px.
  const double distance = pose_distance(points_at(3, 20), camera, forward(5), forward(5.1));
  EXPECT_GT(distance, 0.1);
  EXPECT_LT(distance, 200 * (15 / 14.9 - 1));
}

TEST(PoseDistance, IsInfiniteWhereWhatIsSeenWouldBeBehind) {
  EXPECT_TRUE(std::isinf(pose_distance(points_at(3, 20), camera, SE3d{}, forward(5))));
  EXPECT_TRUE(std::isinf(pose_distance(points_at(3, 20), camera, forward(5), SE3d{})));
}

TEST(PoseDistance, IsInfiniteWhereNothingIsSeen) {
  EXPECT_TRUE(std::isinf(pose_distance(points_at(3, 4), camera, forward(5), forward(5))));
  EXPECT_TRUE(std::isinf(pose_distance(PointSet{}, camera, SE3d{}, SE3d{})));
}

TEST(PoseDistance, IsNotMeasuredToItsEndAboveALimit) {
  const SE3d shifted = SE3d::translation(Vector3<double>(0.1, 0, 0));  // by 4 pixels
  const PointSet points = points_at(5, 5);
  EXPECT_EQ(pose_distance(points, camera, SE3d{}, shifted, 4.1), pose_distance(points, camera, SE3d{}, shifted));
  EXPECT_TRUE(std::isinf(pose_distance(points, camera, SE3d{}, shifted, 3.9)));
  EXPECT_TRUE(is_near(points, camera, SE3d{}, shifted, 4.1));
  EXPECT_FALSE(is_near(points, camera, SE3d{}, shifted, 3.9));
  EXPECT_FALSE(is_near(PointSet{}, camera, SE3d{}, SE3d{}, 1));
}

}  // namespace
