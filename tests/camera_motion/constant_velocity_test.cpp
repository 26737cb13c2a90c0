// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/constant_velocity.hpp"

#include <gtest/gtest.h>

namespace {

using dot::change_of_place;
using dot::SE3d;
using dot::Vector3;

SE3d turned(const SE3d& T, const Vector3<double>& angles) {
  return SE3d{dot::so3::exp(angles), Vector3<double>::Zero()} * T;
}

// A vehicle in a bend: 2.5 m and 0.05 rad in each interval.
TEST(ConstantVelocity, LeadsAlongABend) {
  const SE3d T{dot::so3::exp(Vector3<double>(0, -0.05, 0)), {0.06, 0, -2.5}};
  EXPECT_LT(change_of_place(T, T), 1e-12);
}

// A camera that shakes: it goes straight on at 2.5 m in each interval, and turned before. The last motion in its own
// frame is then `before`.
TEST(ConstantVelocity, LeadsStraightOnWhileTheCameraShakes) {
  const SE3d straight = SE3d::translation({0, 0, -2.5});
  const Vector3<double> shake(0.05, -0.07, 0.02);
  const SE3d before = turned(straight, shake);
  // In the turned camera's frame the same velocity has another direction.
  const SE3d now = turned(straight, -shake) * SE3d{dot::so3::exp(-shake), Vector3<double>::Zero()};
  const Vector3<double> place = -before.t;
  EXPECT_LT(change_of_place(SE3d{now.R, -(now.R * place)}, before), 1e-12);
}

TEST(ConstantVelocity, IsLeftByTheDistanceToTheNearerPlace) {
  const SE3d before{dot::so3::exp(Vector3<double>(0, 0.1, 0)), {0, 0, -1}};
  const Vector3<double> straight(0, 0, 1), further = straight + Vector3<double>(0, 0, 0.03);
  EXPECT_NEAR(change_of_place(SE3d::translation(-further), before), 0.03, 1e-12);
  EXPECT_NEAR(change_of_place(turned(SE3d::translation(-further), {0.3, 0, 0}), before), 0.03, 1e-12);
}

}  // namespace
