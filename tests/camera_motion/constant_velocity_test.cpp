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

// A camera that shakes: it goes straight on in the world, 2.5 m in each interval, and turns as it likes.
TEST(ConstantVelocity, LeadsStraightOnWhileTheCameraShakes) {
  const auto T_c_w = [](const Vector3<double>& angles, double z) {
    return SE3d{dot::so3::exp(angles), Vector3<double>::Zero()} * SE3d::translation({0, 0, -z});
  };
  const SE3d first = T_c_w({0, 0, 0}, 0), second = T_c_w({0.05, -0.07, 0.02}, 2.5),
             third = T_c_w({-0.03, 0.08, 0.1}, 5);
  const SE3d before = second * first.inverse(), now = third * second.inverse();
  EXPECT_LT(change_of_place(now, before), 1e-12);
  EXPECT_GT((now.inverse().t - before.inverse().t).norm(), 0.1);  // along a bend it leads elsewhere
}

TEST(ConstantVelocity, IsLeftByTheDistanceToTheNearerPlace) {
  const SE3d before{dot::so3::exp(Vector3<double>(0, 0.1, 0)), {0, 0, -1}};
  const Vector3<double> straight(0, 0, 1), further = straight + Vector3<double>(0, 0, 0.03);
  EXPECT_NEAR(change_of_place(SE3d::translation(-further), before), 0.03, 1e-12);
  EXPECT_NEAR(change_of_place(turned(SE3d::translation(-further), {0.3, 0, 0}), before), 0.03, 1e-12);
}

}  // namespace
