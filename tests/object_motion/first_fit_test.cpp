// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/first_fit.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace {

using dot::FirstFit;
using dot::ObjectFit;
using dot::Vector3;

const dot::MotionPriorSettings prior;

/// A fit of 0.5 m/s sigma per axis that correlates worse than a sure one, with nothing else against it.
ObjectFit fit(const Vector3<double>& velocity = {5, 0, 0}) {
  ObjectFit out;
  out.reason = dot::Reason::None;
  out.phi = 0.9;
  out.motion.velocity = velocity;
  out.motion.covariance = 0.25 * dot::Matrix3<double>::Identity();
  return out;
}

ObjectFit not_lowest() {
  ObjectFit out = fit();
  out.is_lowest = false;
  return out;
}

ObjectFit turning(double rate) {
  ObjectFit out = fit();
  out.motion.angular_velocity = {0, -rate, 0};
  return out;
}

bool is_doubtful(const ObjectFit& first, const std::optional<ObjectFit>& backwards = std::nullopt) {
  return FirstFit::is_doubtful(first, backwards, prior);
}

TEST(FirstFit, TheLowestMinimumIsTrusted) { EXPECT_FALSE(is_doubtful(fit())); }

TEST(FirstFit, AnotherMinimumThatCostsLessIsADoubt) {
  EXPECT_TRUE(is_doubtful(not_lowest()));
  ObjectFit sure = not_lowest();
  sure.phi = 0.96;
  EXPECT_FALSE(is_doubtful(sure));
}

TEST(FirstFit, TurningFasterThanThingsMostlyDoIsADoubt) {
  EXPECT_FALSE(is_doubtful(turning(2.9 * prior.rotation)));
  EXPECT_TRUE(is_doubtful(turning(3.1 * prior.rotation)));
  dot::MotionPriorSettings lively = prior;
  lively.rotation *= 2;
  EXPECT_FALSE(FirstFit::is_doubtful(turning(3.1 * prior.rotation), std::nullopt, lively));
}

// Both have errors of 0.5 m/s: three sigma of a difference in three axes are sqrt(14.2 * 0.5) = 2.66 m/s.
TEST(FirstFit, TheOtherDirectionTakesTheDoubtAway) {
  for (const ObjectFit& first : {not_lowest(), turning(2)}) {
    EXPECT_FALSE(is_doubtful(first, fit({5, 0, 2.6})));
    EXPECT_TRUE(is_doubtful(first, fit({5, 0, 2.7})));
  }
}

}  // namespace
