// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/candidacy.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Candidacy;
using dot::Matrix3;
using dot::ObjectBelief;
using dot::ObjectStep;
using dot::Reason;
using dot::State;
using dot::Vector3;

constexpr double dt = 0.1;

/// A fit of this velocity, sigma 0.1 m/s.
ObjectStep fitted(const Vector3<double>& velocity) {
  ObjectStep step;
  step.fit.reason = Reason::None;
  step.fit.motion.velocity = velocity;
  step.fit.motion.covariance = 0.01 * Matrix3<double>::Identity();
  step.fit.motion.range = 10;
  step.evidence = step.fit.motion;
  step.has_evidence = true;
  return step;
}

ObjectBelief believed(const Vector3<double>& velocity) {
  ObjectBelief belief;
  belief.velocity_now = velocity;
  belief.velocity_covariance = 0.01 * Matrix3<double>::Identity();
  return belief;
}

TEST(Candidacy, IsConfirmedByFitsThatAgree) {
  Candidacy candidacy;
  candidacy.confirm(fitted({3, 0, 0}), ObjectBelief{}, {}, dt);
  EXPECT_FALSE(candidacy.was_confirmed()) << "the first has nothing to agree with";
  candidacy.confirm(fitted({3.1, 0, 0}), believed({3, 0, 0}), {}, dt);
  EXPECT_TRUE(candidacy.was_confirmed());
  for (int i = 0; i < 100; ++i) candidacy.confirm(fitted({3, 0, 0}), believed({3, 0, 0}), {}, dt);
  EXPECT_EQ(candidacy.confirmed, Candidacy::kMaxConfirmedSeconds);
}

TEST(Candidacy, IsNotConfirmedByFitsThatDifferOrStand) {
  Candidacy candidacy;
  candidacy.confirm(fitted({-3, 0, 0}), believed({3, 0, 0}), {}, dt);
  EXPECT_FALSE(candidacy.was_confirmed()) << "another motion each time";
  candidacy.confirm(fitted({0, 0, 0}), believed({0, 0, 0}), {}, dt);
  EXPECT_FALSE(candidacy.was_confirmed()) << "it stands";
}

TEST(Candidacy, LosesItsConfirmationAgain) {
  Candidacy candidacy;
  candidacy.confirm(fitted({3, 0, 0}), believed({3, 0, 0}), {}, dt);
  ObjectStep hidden;
  hidden.fit.reason = Reason::Occluded;
  candidacy.confirm(hidden, believed({3, 0, 0}), {}, dt);
  EXPECT_TRUE(candidacy.was_confirmed()) << "what is hidden says nothing";
  ObjectStep failed;
  failed.fit.reason = Reason::LowCorrelation;
  candidacy.confirm(failed, believed({3, 0, 0}), {}, dt);
  EXPECT_FALSE(candidacy.was_confirmed());
}

TEST(Candidacy, IsShownWhileItMovesWithSupport) {
  Candidacy candidacy;
  candidacy.confirmed = 0.2;
  candidacy.decide(State::Moving);
  EXPECT_TRUE(candidacy.is_candidate) << "nothing tells that its pixels do not stand";
  candidacy.examine(1, dt);
  candidacy.confirmed = 0;
  candidacy.decide(State::Moving);
  EXPECT_TRUE(candidacy.is_candidate) << "not confirmed";
  candidacy.confirmed = 0.2;
  candidacy.decide(State::NotObservable);
  EXPECT_TRUE(candidacy.is_candidate);
  candidacy.decide(State::Moving);
  EXPECT_FALSE(candidacy.is_candidate);
  for (int i = 0; i < 10; ++i) candidacy.examine(0, dt);
  candidacy.decide(State::Moving);
  EXPECT_TRUE(candidacy.is_candidate) << "its pixels contradict a standing scene no more";
}

TEST(Candidacy, OneFrameDoesNotOutweighThoseBefore) {
  Candidacy candidacy;
  candidacy.examine(1, dt);
  EXPECT_EQ(candidacy.support, 1) << "the first has nothing before it";
  candidacy.examine(0, dt);
  EXPECT_NEAR(candidacy.support, 1 - dt / Candidacy::kSupportSeconds, 1e-12);
  candidacy.examine(0, 10);
  EXPECT_EQ(candidacy.support, 0) << "after a long gap this frame alone counts";
}

/// Else what flickers for ever would be followed for ever, in place of something that moves.
TEST(Candidacy, FailsIfItIsNotConfirmedForLong) {
  Candidacy flickers, moves;
  flickers.is_candidate = moves.is_candidate = true;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(flickers.has_failed(), i * dt > Candidacy::kTrialSeconds + 1e-9) << i;
    flickers.confirm(fitted({i % 2 ? -3. : 3., 0, 0}), believed({0, 3, 0}), {}, dt);
    moves.confirm(fitted({3, 0, 0}), believed({3, 0, 0}), {}, dt);
  }
  EXPECT_TRUE(flickers.has_failed());
  EXPECT_FALSE(moves.has_failed());
}

/// What was shown gets a new trial before it is given up.
TEST(Candidacy, TheTrialStartsAfreshWithEachConfirmation) {
  Candidacy candidacy;
  candidacy.is_candidate = true;
  for (int i = 0; i < 20; ++i) candidacy.confirm(fitted({3, 0, 0}), believed({3, 0, 0}), {}, dt);
  ObjectStep hidden;
  hidden.fit.reason = Reason::Occluded;
  for (int i = 0; i < 20; ++i) candidacy.confirm(hidden, believed({3, 0, 0}), {}, dt);
  int until = 0;
  while (!candidacy.has_failed() && until < 100) {
    candidacy.confirm(fitted({-3, 0, 0}), believed({3, 0, 0}), {}, dt);
    ++until;
  }
  EXPECT_GE(until * dt, Candidacy::kTrialSeconds);
  EXPECT_LE(until * dt, Candidacy::kTrialSeconds + Candidacy::kMaxConfirmedSeconds + 2 * dt);
}

}  // namespace
