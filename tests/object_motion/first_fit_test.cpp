// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/first_fit.hpp"

#include <gtest/gtest.h>

namespace {

using dot::FirstFit;
using dot::ObjectFit;
using dot::Vector3;

const dot::MotionPriorSettings prior;

/// A fit that correlates worse than a sure one, with nothing else against it.
ObjectFit unsure() {
  ObjectFit out;
  out.reason = dot::Reason::None;
  out.phi = 0.9;
  return out;
}

ObjectFit turning(double rate, double sigma = 0) {
  ObjectFit out = unsure();
  out.motion.angular_velocity = {0, -rate, 0};
  out.motion.angular_covariance = Vector3<double>(0, sigma * sigma, 0).asDiagonal();
  return out;
}

TEST(FirstFit, TheBestMinimumIsTrusted) { EXPECT_FALSE(FirstFit::is_doubtful(unsure(), true, prior)); }

TEST(FirstFit, ABetterMinimumThatWasRefusedIsADoubt) {
  ObjectFit fit = unsure();
  EXPECT_TRUE(FirstFit::is_doubtful(fit, false, prior));
  fit.phi = 0.96;
  EXPECT_FALSE(FirstFit::is_doubtful(fit, false, prior));
}

TEST(FirstFit, TurningFasterThanThingsMostlyDoIsADoubt) {
  EXPECT_FALSE(FirstFit::is_doubtful(turning(2.9 * prior.rotation), true, prior));
  EXPECT_TRUE(FirstFit::is_doubtful(turning(3.1 * prior.rotation), true, prior));
  EXPECT_FALSE(FirstFit::is_doubtful(turning(3.1 * prior.rotation, prior.rotation), true, prior)) << "it may not turn";
  dot::MotionPriorSettings lively = prior;
  lively.rotation *= 2;
  EXPECT_FALSE(FirstFit::is_doubtful(turning(3.1 * prior.rotation), true, lively));
}

// Both have errors of 0.5 m/s: three sigma of a difference in three axes are sqrt(14.2 * 0.5) = 2.66 m/s.
TEST(FirstFit, AgreesWithinThreeSigma) {
  dot::MotionEstimate a, b;
  a.covariance = b.covariance = 0.25 * dot::Matrix3<double>::Identity();
  a.velocity = {5, 0, 0};
  b.velocity = {5, 0, 2.6};
  EXPECT_TRUE(FirstFit::agree(a, b));
  b.velocity = {5, 0, 2.7};
  EXPECT_FALSE(FirstFit::agree(a, b));
}

}  // namespace
