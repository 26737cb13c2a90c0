// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/move_apart.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Matrix3;
using dot::move_apart;
using dot::PartMotion;
using dot::Vector3;

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
  EXPECT_TRUE(move_apart(front, back, kStanding)) << "if it does not turn";
  front.angular_velocity = {0, -0.5, 0};
  back.angular_covariance = unknown;
  EXPECT_FALSE(move_apart(front, back, kStanding));
  front.angular_velocity.setZero();
  front.angular_covariance = unknown;
  EXPECT_FALSE(move_apart(front, back, kStanding)) << "if it may";
}

// A body of two parts, one of them measured at twice its distance. Seen from a camera at 10 m/s.
TEST(MoveApart, NotABodyWhosePartSeemsFarther) {
  const Vector3<double> camera(0, 0, 10), velocity(2, 0, 6);
  const Vector3<double> seeming = camera + 2 * (velocity - camera);
  EXPECT_FALSE(move_apart(part({1, 1, 10}, velocity), part({2, 2, 20}, seeming), camera));
  EXPECT_FALSE(move_apart(part({2, 2, 20}, seeming), part({1, 1, 10}, velocity), camera)) << "in either order";
  EXPECT_TRUE(move_apart(part({1, 1, 10}, velocity), part({2, 2, 20}, {0, 0, 0}), camera)) << "what stands behind it";
  EXPECT_TRUE(move_apart(part({1, 1, 10}, velocity), part({2, 2, 20}, seeming), kStanding)) << "another camera";
}

TEST(MoveApart, NotWhatIsBehindTheCamera) {
  EXPECT_FALSE(move_apart(part({0, 1, -1}, {0, 0, 0}), part({1, 1, 15}, {5, 0, 0}), kStanding));
}

}  // namespace
