// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/fit.hpp"

#include <gtest/gtest.h>

#include "support/object_fit.hpp"
#include "support/random.hpp"

namespace {

using dot::ObjectFit;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using dot::test::any_covariance;
using dot::test::camera_at;
using dot::test::dt;
using dot::test::pose;
using dot::test::Random;

const Vector3<double> place(1.5, 0.8, 8);

// A fit from the new frame back to the old one, reversed, is that from the old to the new.
TEST(Reversed, IsTheMotionForwards) {
  for (const SE3d& step : {SE3d::translation({0.2, 0, 0.05}), pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1})}) {
    const SE3d now = camera_at(3), C = camera_at(2).inverse() * now;
    const Vector3<double> centroid = now.inverse() * (step * place);
    ObjectFit back;
    back.reason = dot::Reason::None;
    back.T_o = now.inverse() * step.inverse() * now;
    back.motion.velocity = (back.T_o * centroid - centroid) / dt;
    back.motion.covariance = any_covariance<3>(3);
    back.sigma = any_covariance<6>(4);
    back.motion.angular_velocity = dot::so3::log(back.T_o.R) / dt;
    const ObjectFit out = back.reversed(C);
    EXPECT_TRUE(out.ok());
    const SE3d forwards = camera_at(2).inverse() * step * camera_at(2);
    const Vector6<double> error = (out.T_o * forwards.inverse()).log();
    EXPECT_LT(error.norm(), 1e-12);
    const Vector3<double> before = camera_at(2).inverse() * place;
    EXPECT_LT((out.motion.velocity - (forwards * before - before) / dt).norm(), 1e-12);
    EXPECT_LT((out.motion.angular_velocity - dot::so3::log(forwards.R) / dt).norm(), 1e-9);
    const Vector3<double> along(0.3, -0.5, 0.8);
    EXPECT_NEAR((C.R * along).dot(out.motion.covariance * (C.R * along)), along.dot(back.motion.covariance * along),
                1e-12);

    // A twist x of the motion back about where it leads is one of the motion forwards about where that leads.
    Random random(5);
    Vector6<double> x;
    for (int k = 0; k < 6; ++k) x[k] = random.normal(1e-5);
    const Vector3<double> then = back.T_o * centroid;
    ObjectFit other = back;
    other.T_o = SE3d::translation(then) * SE3d::exp(x) * SE3d::translation(-then) * back.T_o;
    const Vector3<double> moved = C * centroid;
    const SE3d change =
        SE3d::translation(-moved) * other.reversed(C).T_o * out.T_o.inverse() * SE3d::translation(moved);
    ObjectFit of_x = back;
    of_x.sigma = x * x.transpose();
    const Vector6<double> y = change.log();
    EXPECT_LT((of_x.reversed(C).sigma - y * y.transpose()).norm(), 1e-3 * x.squaredNorm());
  }
}

}  // namespace
