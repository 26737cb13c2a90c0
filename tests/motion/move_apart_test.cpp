// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/move_apart.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Matrix3;
using dot::move_apart;
using dot::PartMotion;
using dot::Vector3;
using dot::moving_apart::are_one_body;

const Vector3<double> kStanding = Vector3<double>::Zero();

PartMotion part(const Vector3<double>& at, const Vector3<double>& velocity, double sigma = 0.2) {
  PartMotion out;
  out.at = at;
  out.size = 2;
  out.velocity = velocity;
  out.covariance = sigma * sigma * Matrix3<double>::Identity();
  out.angular_covariance = 0.01 * 0.01 * Matrix3<double>::Identity();
  return out;
}

TEST(MoveApart, WhatMovesOtherwise) {
  EXPECT_TRUE(move_apart(part({0, 1, 8}, {0, 0, 0}), part({1, 1, 15}, {5, 0, 0}), kStanding));
  EXPECT_TRUE(move_apart(part({1, 1, 15}, {5, 0, 0}), part({0, 1, 8}, {0, 0, 0}), kStanding)) << "in either order";
}

TEST(MoveApart, NotWithinTheErrors) {
  EXPECT_FALSE(move_apart(part({0, 1, 8}, {0, 0, 0}), part({1, 1, 15}, {1, 0, 0}), kStanding));
  EXPECT_FALSE(move_apart(part({0, 1, 8}, {0, 0, 0}, 1), part({1, 1, 15}, {5, 0, 0}, 1), kStanding));
}

// A bus that turns: its ends have other velocities than its middle.
TEST(MoveApart, NotTheEndsOfABodyThatTurns) {
  const Matrix3<double> unknown = 0.35 * 0.35 * Matrix3<double>::Identity();
  PartMotion front = part({0, 1, 8}, {3, 0, 0}), back = part({0, 1, 12}, {3 - 0.5 * 4, 0, 0});
  back.angular_covariance = unknown;
  EXPECT_FALSE(are_one_body(front, back)) << "if it does not turn";
  front.angular_velocity = {0, -0.5, 0};
  EXPECT_TRUE(are_one_body(front, back));
  EXPECT_FALSE(move_apart(front, back, kStanding));
  back.at.z() = 30;
  EXPECT_TRUE(are_one_body(front, back)) << "a body is not longer than what is seen of it";
  front.angular_velocity.setZero();
  front.angular_covariance = unknown;
  EXPECT_TRUE(are_one_body(front, back)) << "if it may turn";
}

TEST(MoveApart, TakesTheRotationThatIsKnownBetter) {
  PartMotion front = part({0, 1, 80}, {3, 0, 0}), back = part({0, 1, 84}, {3 - 0.5 * 4, 0, 0});
  front.size = 0.5, back.size = 3.5;
  front.angular_velocity = {0, -0.5, 0};
  back.angular_covariance = 0.05 * 0.05 * Matrix3<double>::Identity();
  EXPECT_FALSE(move_apart(front, back, kStanding));
  EXPECT_FALSE(move_apart(back, front, kStanding));
  back.angular_covariance *= 0.01;
  EXPECT_TRUE(move_apart(front, back, kStanding)) << "that the body does not turn";
}

// A body of two parts, one of them measured at twice its distance. Seen from a camera at 10 m/s.
TEST(MoveApart, NotABodyWhosePartSeemsFarther) {
  const Vector3<double> camera(0, 0, 10), velocity(2, 0, 6);
  const auto small = [](const Vector3<double>& at, const Vector3<double>& v) {
    PartMotion out = part(at, v);
    out.size = 0.2;
    return out;
  };
  const PartMotion near = small({1, 1, 10}, velocity), far = small({2, 2, 20}, camera + 2 * (velocity - camera));
  EXPECT_FALSE(move_apart(near, far, camera));
  EXPECT_FALSE(move_apart(far, near, camera)) << "in either order";
  EXPECT_TRUE(move_apart(near, small({2, 2, 20}, {0, 0, 0}), camera)) << "what stands behind it";
  EXPECT_TRUE(move_apart(near, far, kStanding)) << "another camera";
}

// The ratio of the depths of a deep body is not known: here 1.3 instead of 1.6.
TEST(MoveApart, NotADeepBodyWhosePartSeemsFarther) {
  const Vector3<double> velocity(0, 0, 8);
  EXPECT_FALSE(move_apart(part({1, 1, 5}, velocity), part({1, 1, 8}, 1.3 * velocity), kStanding));
}

TEST(MoveApart, NotWhatIsBehindTheCamera) {
  EXPECT_FALSE(move_apart(part({0, 1, -1}, {0, 0, 0}), part({1, 1, 15}, {5, 0, 0}), kStanding));
}

}  // namespace
