// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/known_velocity.hpp"

#include <gtest/gtest.h>

namespace {

using dot::KnownVelocity;
using dot::Matrix3;
using dot::MotionEstimate;
using dot::Vector3;

MotionEstimate fit(const Vector3<double>& velocity, const Vector3<double>& sigma) {
  MotionEstimate e;
  e.velocity = velocity;
  e.covariance = sigma.cwiseAbs2().asDiagonal();
  return e;
}

TEST(KnownVelocity, NothingKnownContradictsNothing) {
  EXPECT_FALSE(KnownVelocity{}.contradicts(fit({50, 0, 0}, {0.01, 0.01, 0.01}), 10));
}

TEST(KnownVelocity, AccelerationAndErrorsAreAllowedFor) {
  const Vector3<double> sure(1e-6, 1e-6, 1e-6);
  KnownVelocity known{{9, 0, 0}, Matrix3<double>::Zero(), 0.1};
  EXPECT_FALSE(known.contradicts(fit({9, 0, 0}, sure), 10));
  EXPECT_FALSE(known.contradicts(fit({8.01, 0, 0}, sure), 10));
  EXPECT_TRUE(known.contradicts(fit({7.99, 0, 0}, sure), 10));
  EXPECT_FALSE(known.contradicts(fit({7.99, 0, 0}, sure), 11));
  known.seconds = 0.2;
  EXPECT_FALSE(known.contradicts(fit({7.99, 0, 0}, sure), 10));
  known.seconds = 0.1;
  // Errors of the fit and of what was known, together 0.5 = hypot(0.3, 0.4) along each axis, widen that:
  // d^2 <= 14.2 * 0.25 + 1.
  known.covariance = 0.16 * Matrix3<double>::Identity();
  EXPECT_FALSE(known.contradicts(fit({9 - 2.13, 0, 0}, {0.3, 0.3, 0.3}), 10));
  EXPECT_TRUE(known.contradicts(fit({9 - 2.14, 0, 0}, {0.3, 0.3, 0.3}), 10));
}

// A far object's velocity along the ray may be anything while its sideways one is measured well; and that is not
// excused by an error along the ray that came with it.
TEST(KnownVelocity, EachDirectionHasItsOwnError) {
  const KnownVelocity known{{9, 0, 0}, Matrix3<double>::Zero(), 0.1};
  EXPECT_FALSE(known.contradicts(fit({9, 0, 12}, {0.05, 0.05, 5}), 10));
  EXPECT_TRUE(known.contradicts(fit({0, 0, 0}, {0.05, 0.05, 5}), 10));
  EXPECT_TRUE(known.contradicts(fit({7, 0, 12}, {0.05, 0.05, 5}), 10));
}

// The mean of two Gaussians is (V^-1 + P^-1)^-1 (V^-1 v_fit + P^-1 v): a fit that is sure stays, one that knows nothing
// becomes what was known, each direction for itself.
TEST(KnownVelocity, CorrectsByTheWeightedMean) {
  Matrix3<double> P;
  P << 0.5, 0.1, 0, 0.1, 0.3, -0.1, 0, -0.1, 0.8;
  const KnownVelocity known{{9, 0.5, -2}, P, 0.1};
  const MotionEstimate poor = fit({6, 0, 3}, {0.4, 0.2, 5});
  const Matrix3<double> V = poor.covariance;
  const Vector3<double> mean =
      (V.inverse() + P.inverse()).inverse() * (V.inverse() * poor.velocity + P.inverse() * known.velocity);
  EXPECT_LT((poor.velocity + known.correction(poor) - mean).norm(), 1e-12);
  EXPECT_LT(known.correction(fit({6, 0, 3}, {1e-4, 1e-4, 1e-4})).norm(), 1e-6);
  EXPECT_LT((known.correction(fit({6, 0, 3}, {1e4, 1e4, 1e4})) - Vector3<double>(3, 0.5, -5)).norm(), 1e-6);
}

}  // namespace
