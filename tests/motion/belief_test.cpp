// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/belief.hpp"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/numeric_jacobian.hpp"
#include "support/random.hpp"

namespace {

using dot::Belief;
using dot::Matrix3;
using dot::MotionEstimate;
using dot::Vector3;
using dot::VelocitySettings;
using dot::test::matrices_match;
using dot::test::Random;

const VelocitySettings settings;
const Matrix3<double> I = Matrix3<double>::Identity();

MotionEstimate fit(const Vector3<double>& velocity, double sigma, double interval = 0.1, double intervals = 1) {
  MotionEstimate e;
  e.velocity = velocity;
  e.covariance = sigma * sigma * I;
  e.span_seconds = interval;
  e.span_frames = intervals;
  e.range = 15;
  return e;
}

double sq(double x) { return x * x; }

/// Log odds that one fit brings to a new belief.
double evidence(const MotionEstimate& e) {
  Belief belief;
  const double before = belief.log_odds;
  belief.update(e, settings.v0, settings);
  return belief.log_odds - before;
}

TEST(Belief, BeginsUndecided) {
  const Belief belief;
  EXPECT_NEAR(belief.p_moving(), Belief::kPrior, 1e-12);
  EXPECT_LT(belief.p_moving(), settings.keep);
  EXPECT_GT(belief.p_moving(), 1 - settings.keep);
  EXPECT_FALSE(belief.has_velocity());
}

TEST(Belief, WeighsAFit) {
  EXPECT_GT(evidence(fit({3, 0, 0}, 0.2)), 2);
  EXPECT_GT(evidence(fit({0, 0, -8}, 0.5)), 2);
  EXPECT_LT(evidence(fit({0, 0, 0}, 0.2)), -1);
  EXPECT_LT(evidence(fit({0.1, 0, -0.1}, 0.1)), -1);
}

// Once it is certain that it moves, a still faster fit may as well be a wrong one.
TEST(Belief, MoreSpeedNeverSpeaksForStanding) {
  const double certain = 5;
  for (const double sigma : {0.05, 0.2, 1.0, 4.0}) {
    double before = evidence(fit({0, 0, 0}, sigma));
    for (double speed = 0.1; speed < 12; speed += 0.1) {
      const double now = evidence(fit({0.6 * speed, 0, 0.8 * speed}, sigma));
      EXPECT_GE(now, std::min(before, certain) - 1e-9) << sigma << ", " << speed;
      before = now;
    }
  }
}

TEST(Belief, AFitThatKnowsNothingSaysNothing) {
  for (const double sigma : {100.0, 1000.0})
    for (const double speed : {0.0, 3.0, 30.0}) EXPECT_NEAR(evidence(fit({0, 0, speed}, sigma)), 0, 0.5);
}

TEST(Belief, DoesNotDependOnTheAxes) {
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0.4, -1.1, 0.7));
  MotionEstimate e = fit({0.8, -0.3, 1.2}, 0);
  e.covariance = Vector3<double>(0.01, 0.04, 1).asDiagonal();
  MotionEstimate turned = e;
  turned.velocity = R * e.velocity;
  turned.covariance = R * e.covariance * R.transpose();
  Belief a, b;
  for (int i = 0; i < 2; ++i) a.update(e, 0.5, settings), b.update(turned, 0.5, settings);
  EXPECT_TRUE(matrices_match(b.velocity, Vector3<double>(R * a.velocity), 1e-9));
  EXPECT_TRUE(matrices_match(b.covariance, Matrix3<double>(R * a.covariance * R.transpose()), 1e-9));
  // The filter's covariance is turned with it; the ball |v| <= v0 is taken as a cube along its axes, nothing else.
  EXPECT_NEAR(a.log_odds, b.log_odds, 1e-6);
}

TEST(Belief, OneFitBringsNoMoreThanItsTime) {
  for (const double interval : {1 / 5.0, 1 / 10.0, 1 / 30.0}) {
    EXPECT_LE(evidence(fit({20, 0, 0}, 0.01, interval)), settings.max_evidence_rate * interval + 1e-9);
    EXPECT_GE(evidence(fit({0, 0, 0}, 1e-4, interval)), -settings.max_evidence_rate * interval - 1e-9);
  }
  Belief belief;
  for (int i = 0; i < 100; ++i) belief.update(fit({20, 0, 0}, 0.1), 0.5, settings);
  EXPECT_LE(belief.log_odds, settings.max_log_odds);
  for (int i = 0; i < 100; ++i) belief.update(fit({0, 0, 0}, 0.1), 0.5, settings);
  EXPECT_GE(belief.log_odds, -settings.max_log_odds);
}

TEST(Belief, LongBaselinesOverlapAndCountLess) {
  // A fit over four frames shares three of them with the one before.
  const double once = evidence(fit({0, 0, 0}, 1, 0.1, 1)), four = evidence(fit({0, 0, 0}, 1, 0.4, 4));
  EXPECT_LT(once, -0.2);
  EXPECT_GT(once, -settings.max_evidence_rate * 0.1);
  EXPECT_NEAR(four, once / 2, 1e-9);
}

TEST(Belief, ForgetsWithTimeAtAnyFrameRate) {
  for (const double start : {5.0, -5.0}) {
    Belief coarse, fine;
    coarse.log_odds = fine.log_odds = start;
    double p = coarse.p_moving();
    for (int i = 0; i < 50; ++i) {
      coarse.predict(0.2, I, settings);
      for (int k = 0; k < 6; ++k) fine.predict(0.2 / 6, I, settings);
      // Towards not knowing, never past it.
      EXPECT_LT(std::abs(coarse.p_moving() - Belief::kPrior), std::abs(p - Belief::kPrior));
      EXPECT_GT((coarse.p_moving() - Belief::kPrior) * start, 0);
      EXPECT_NEAR(coarse.p_moving(), fine.p_moving(), 5e-3);
      p = coarse.p_moving();
    }
  }
}

// A fit that may be wrong raises the probability as far as the decision at most. The next that agrees decides, even if
// it is doubtful as well. One that does not agree is another first one.
TEST(Belief, ADoubtfulFitAloneDoesNotDecideThatItMoves) {
  MotionEstimate e = fit({8, 0, 0}, 0.3), other = fit({0, 0, -6}, 0.3);
  e.is_doubtful = other.is_doubtful = true;
  for (const double decide : {0.8, 0.9, 0.99}) {
    VelocitySettings s = settings;
    s.decide = decide;
    Belief belief;
    belief.update(e, s.v0, s);
    EXPECT_LT(belief.p_moving(), decide);
    EXPECT_NEAR(belief.p_moving(), decide, 1e-6);
    EXPECT_TRUE(belief.has_velocity());
    Belief contradicted = belief;
    contradicted.update(other, s.v0, s);
    EXPECT_LT(contradicted.p_moving(), decide);
    belief.update(e, s.v0, s);
    EXPECT_GT(belief.p_moving(), decide);
  }
}

TEST(Belief, ADoubtfulFitSpeaksForStandingAndTakesNothingBack) {
  MotionEstimate stands = fit({0, 0, 0}, 0.2), moves = fit({8, 0, 0}, 0.3);
  const double sure = evidence(stands);
  stands.is_doubtful = moves.is_doubtful = true;
  EXPECT_EQ(evidence(stands), sure);
  Belief belief;
  belief.log_odds = 4;  // further than the decision
  belief.update(moves, settings.v0, settings);
  EXPECT_EQ(belief.log_odds, 4);
}

TEST(Belief, VelocityTurnsWithTheCameraAndGrowsUncertain) {
  Belief belief;
  MotionEstimate e = fit({2, 0, 5}, 0);
  e.covariance = Vector3<double>(0.01, 0.02, 0.5).asDiagonal();
  belief.update(e, 0.5, settings);
  const Belief before = belief;
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0, 0.5, 0.1));
  belief.predict(0.1, R, settings);
  EXPECT_TRUE(matrices_match(belief.velocity, Vector3<double>(R * before.velocity), 1e-12));
  EXPECT_TRUE(
      matrices_match(Matrix3<double>(belief.covariance), Matrix3<double>(belief.covariance.transpose()), 1e-12));
  const Matrix3<double> grown = R.transpose() * belief.covariance * R - before.covariance;
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(grown);
  EXPECT_GE(eigen.eigenvalues()[0], -1e-9);
  EXPECT_GT(eigen.eigenvalues()[2], 0);
}

TEST(Belief, FilterConvergesAndKnowsHowWell) {
  const Vector3<double> truth(3, 0, -6);
  double chi2 = 0;
  const int seeds = 100;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Random random(seed);
    Belief belief;
    for (int i = 0; i < 20; ++i) {
      belief.update(fit(truth + random.normal3(0.5), 0.5), 0.5, settings);
      if (i < 19) belief.predict(0.1, I, settings);
    }
    EXPECT_LT(belief.covariance.trace(), 3 * 0.25);  // better than one fit
    const Vector3<double> e = belief.velocity - truth;
    EXPECT_LT(e.norm(), 1.5);
    chi2 += e.dot(belief.covariance.ldlt().solve(e)) / 3 / seeds;
  }
  // The filter allows for accelerations that this object has not: below 1, but of the right size.
  EXPECT_GT(chi2, 0.2);
  EXPECT_LT(chi2, 1.3);
}

TEST(Belief, FilterStartsAnewWhereFitsContradictIt) {
  Belief belief;
  const auto see = [&](double vx, int fits) {
    for (int i = 0; i < fits; ++i) {
      belief.update(fit({vx, 0, 0}, 0.3), 0.5, settings);
      belief.predict(0.1, I, settings);
    }
  };
  see(10, 1);
  see(-5, 1);
  EXPECT_NEAR(belief.velocity.x(), -5, 0.3) << "one is no better than the other";
  see(-5, 9);
  see(10, 2);
  EXPECT_NEAR(belief.velocity.x(), -5, 0.3) << "ten against two";
  see(10, 1);
  EXPECT_NEAR(belief.velocity.x(), 10, 0.3);
}

// A fit that has locked onto what hides the object, and knows next to nothing, must not cost what is known of it.
TEST(Belief, AFitThatKnowsLittleDoesNotEndWhatIsKnown) {
  Belief belief;
  for (int i = 0; i < 10; ++i) {
    belief.update(fit({2, 0, 15}, 1), 0.5, settings);
    belief.predict(0.1, I, settings);
  }
  MotionEstimate wrong = fit({7, 0, -6}, 0, 0.2, 2);
  wrong.covariance = Vector3<double>(0.5, 0.5, 280).asDiagonal();
  belief.update(wrong, 0.5, settings);
  belief.predict(0.1, I, settings);
  EXPECT_NEAR(belief.velocity.z(), 15, 0.5);
  EXPECT_LT(belief.covariance(2, 2), 1);
}

/// What two seconds of fits against a frame 0.4 s back leave, at a frame rate.
struct AfterTwoSeconds {
  Belief belief;
  double variance = 0;  ///< of the velocity, between what it is just before and just after a fit (geometric mean)
};
AfterTwoSeconds after_two_seconds(double rate, const Vector3<double>& velocity, double sigma) {
  AfterTwoSeconds out;
  const int frames = static_cast<int>(std::lround(2 * rate));
  for (int i = 0; i < frames; ++i) {
    out.belief.update(fit(velocity, sigma, 0.4, 0.4 * rate), 0.5, settings);
    const double after = out.belief.covariance(0, 0);
    out.belief.predict(1 / rate, I, settings);
    out.variance = std::sqrt(after * out.belief.covariance(0, 0));
  }
  return out;
}

TEST(Belief, GrowsUncertainByTimeAtAnyFrameRate) {
  const auto grown = [](double rate) {
    Belief belief;
    belief.update(fit({3, 0, 0}, 0.2), 0.5, settings);
    const double before = belief.covariance(0, 0);
    for (int i = 0; i < std::lround(rate); ++i) belief.predict(1 / rate, I, settings);
    return belief.covariance(0, 0) - before;
  };
  const double range = fit({3, 0, 0}, 0.2).range;
  for (const double rate : {5.0, 10.0, 30.0, 60.0})
    EXPECT_NEAR(grown(rate), sq(settings.usual_acceleration_at(range)) * Belief::kAccelerationSeconds, 1e-9) << rate;
}

// But for velocities at which the decision changes, here some .3 m/s if they are known to .1 m/s.
TEST(Belief, TheSameSecondsGiveTheSameBeliefAtAnyFrameRate) {
  for (const double speed : {0.0, 0.2, 1.5, 3.0})
    for (const double sigma : {0.1, 0.4}) {
      const AfterTwoSeconds at_10 = after_two_seconds(10, {speed, 0, 0}, sigma);
      for (const double rate : {5.0, 30.0, 60.0}) {
        const AfterTwoSeconds at = after_two_seconds(rate, {speed, 0, 0}, sigma);
        EXPECT_NEAR(at.belief.p_moving(), at_10.belief.p_moving(), 0.05)
            << speed << " m/s, sigma " << sigma << ", " << rate << " Hz";
        // A fit every 0.2 s is half as many independent ones: the root of two more of variance.
        const double expected = rate < 10 ? std::sqrt(2) : 1;
        EXPECT_NEAR(at.variance / at_10.variance, expected, 0.1) << rate;
      }
    }
}

/// P(moves) after fits over 0.4 s at 10 Hz, each with an error of its own.
/// @param velocity true, m/s. @param sigma of the fits, m/s.
double p_after(double seconds, const Vector3<double>& velocity, const Vector3<double>& sigma, unsigned seed) {
  Random random(seed);
  Belief belief;
  for (int i = 0; i < 10 * seconds; ++i) {
    MotionEstimate e = fit(velocity + random.normal3(1).cwiseProduct(sigma), 0, 0.4, 4);
    e.covariance = sigma.cwiseAbs2().asDiagonal();
    belief.update(e, settings.v0_at(e.range), settings);
    belief.predict(0.1, I, settings);
  }
  return belief.p_moving();
}

// Somebody who walks towards the camera: sideways still, and the speed along the ray is hardly known from one fit. A
// parked car, measured as badly, stands.
TEST(Belief, WhatComesSlowlyAlongTheRayIsToldInAFewSeconds) {
  const Vector3<double> sigma(0.2, 0.2, 0.8);
  int told = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    told += p_after(4, {0, 0, -1.5}, sigma, seed) > settings.decide;
    EXPECT_LT(p_after(4, {0, 0, 0}, sigma, seed), 1 - settings.decide) << seed;
  }
  EXPECT_GE(told, 36);
}

// Errors of the depth last. A velocity that stays wrong by a sigma is no evidence that the object moves, nor is one
// that is measured well, but is some half of v0 (0.5 m/s at this range).
TEST(Belief, AnErrorThatLastsIsNoEvidence) {
  for (const double rate : {5.0, 10.0, 30.0}) {
    EXPECT_LT(after_two_seconds(rate, {0.3, 0, 0}, 0.05).belief.p_moving(), 0.1) << rate << " Hz";
    for (const double sigma : {0.02, 0.05, 0.1, 0.2})
      EXPECT_LT(after_two_seconds(rate, {0.2, 0, 0}, sigma).belief.p_moving(), 0.1) << sigma << ", " << rate << " Hz";
    for (const double sigma : {0.4, 0.8})
      EXPECT_LT(after_two_seconds(rate, {0, 0, sigma}, sigma).belief.p_moving(), 0.9) << sigma << ", " << rate << " Hz";
  }
}

// The same velocity again and again is less evidence if errors of the object's depth may have caused it.
TEST(Belief, AnErrorOfTheObjectsDepthLasts) {
  const Vector3<double> sigma(0.2, 0.2, 0.8);
  const auto p = [&](double speed, double share_of_depth) {
    Belief belief;
    for (int i = 0; i < 40; ++i) {
      MotionEstimate e = fit({0, 0, -speed}, 0, 0.4, 4);
      e.covariance = sigma.cwiseAbs2().asDiagonal();
      e.depth_covariance(2, 2) = share_of_depth * e.covariance(2, 2);
      belief.update(e, settings.v0_at(e.range), settings);
      belief.predict(0.1, I, settings);
    }
    return belief.p_moving();
  };
  EXPECT_GT(p(1.2, 0), settings.decide);
  EXPECT_LT(p(1.2, 0.9), 0.2);
  EXPECT_NEAR(p(1.5, 0.9), 0.5, 0.2);
  EXPECT_GT(p(2, 0.9), settings.decide);
}

// Successive fits to one reference have its error in common. What they say together is less than what fits to as many
// references say.
TEST(Belief, FitsToOneReferenceShareItsError) {
  const Vector3<double> sigma(0.3, 0.1, 2.5);
  const double common = std::sqrt(dot::ReferenceError::kShare), own = std::sqrt(1 - dot::ReferenceError::kShare);
  int called_moving = 0, called_moving_by_others = 0, told = 0;  // more probably than not; with certainty
  for (unsigned seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const Vector3<double> shared = random.normal3(1);
    Belief stands, stands_by_others, moves;
    for (int i = 1; i <= 5; ++i) {
      const Vector3<double> error = sigma.cwiseProduct(common * shared + own * random.normal3(1));
      const auto update = [&](const Vector3<double>& velocity, int frames, Belief& belief) {
        MotionEstimate e = fit(velocity, 0, 0.1 * frames, frames);
        e.covariance = sigma.cwiseAbs2().asDiagonal();
        belief.update(e, settings.v0_at(e.range), settings);
        belief.predict(0.1, I, settings);
      };
      update(error, i, stands);
      update(error, 6 - i, stands_by_others);
      update(error + Vector3<double>(0, 0, -12), i, moves);
    }
    called_moving += stands.p_moving() > 0.5;
    called_moving_by_others += stands_by_others.p_moving() > 0.5;
    told += moves.p_moving() > settings.decide;
  }
  EXPECT_GT(called_moving_by_others, 50);
  EXPECT_LT(called_moving, 10);
  EXPECT_GT(told, 1900);
}

/// A fit of a box of a decimetre, 1.5 m away, that turns about a standing centre.
MotionEstimate turning_fit(double angular_velocity, double sigma) {
  MotionEstimate e = fit({0, 0, 0}, 0.003);
  e.range = 1.5;
  e.angular_velocity = {0, angular_velocity, 0};
  e.angular_covariance = sigma * sigma * I;
  e.inertia = 0.07 * 0.07 * I;
  return e;
}
double log_odds_after(const MotionEstimate& e, int fits, const VelocitySettings& s) {
  Belief belief;
  for (int i = 0; i < fits; ++i) belief.update(e, s.v0_at(e.range), s);
  return belief.log_odds;
}

TEST(Belief, WhatTurnsOnTheSpotMoves) {
  EXPECT_GT(log_odds_after(turning_fit(0.6, 0.05), 3, settings), 3);
  EXPECT_LT(log_odds_after(turning_fit(0, 0.05), 3, settings), -3);
  EXPECT_LT(log_odds_after(turning_fit(0.6, 1), 3, settings), -3);  // an uncertain rotation says nothing
  EXPECT_GT(log_odds_after(turning_fit(-0.6, 0.05), 3, settings), 3);
  VelocitySettings without = settings;
  without.most_turning = 0;
  EXPECT_LT(log_odds_after(turning_fit(0.6, 0.05), 3, without), -3);
}

/// Log odds after a second of fits, each with an error of its own of N(0, sigma^2). @param span frames of each fit
double log_odds_in_time(const MotionEstimate& truth, double sigma, unsigned seed, int span = 1) {
  Random random(seed);
  Belief belief;
  Vector3<double> error = Vector3<double>::Zero();
  for (int i = 0; i < 10; ++i) {
    MotionEstimate e = truth;
    if (i % span == 0) error = random.normal3(sigma);  // overlapping fits have the same
    e.angular_velocity += error;
    e.span_frames = span, e.span_seconds = 0.1 * span;
    belief.update(e, settings.v0_at(e.range), settings);
    belief.predict(0.1, I, settings);
  }
  return belief.log_odds;
}

// One fit of 26 degrees a second that is right to 5 may be wrong. Ten that agree are not.
TEST(Belief, FitsThatAgreeOnATurnAreEvidence) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    EXPECT_GT(log_odds_in_time(turning_fit(0.45, 0.09), 0.09, seed), 3) << seed;
    EXPECT_LT(log_odds_in_time(turning_fit(0, 0.09), 0.09, seed), -2) << seed;
    EXPECT_LT(log_odds_in_time(turning_fit(0, 0.09), 0.2, seed), -1) << seed;  // worse than they say
  }
}

TEST(Belief, FitsThatOverlapAreNoEvidenceForEachOther) {
  for (unsigned seed = 0; seed < 20; ++seed)
    EXPECT_LT(log_odds_in_time(turning_fit(0, 0.05), 0.1, seed, 3), -1) << seed;
}

TEST(Belief, AMoverThatDoesNotTurnLosesNothing) {
  MotionEstimate mover = turning_fit(0, 0.05), unknown = mover;
  mover.velocity = unknown.velocity = {0.012, 0, 0};  // little more than v0
  unknown.inertia.setZero();
  EXPECT_NEAR(log_odds_after(mover, 1, settings), log_odds_after(unknown, 1, settings), 0.02);
}

TEST(Belief, ARotationOfAFarObjectIsNoEvidence) {
  MotionEstimate far = turning_fit(0.3, 0.03);
  far.range = 30;
  far.inertia = 5 * I;  // of a truck
  far.covariance = 0.04 * I;
  EXPECT_LT(log_odds_after(far, 3, settings), 0);
  far.angular_velocity[1] = 0.5;
  EXPECT_LT(log_odds_in_time(far, 0.03, 1), -2);  // nor where all fits agree: errors of the depth stay
}

// One fit of a parked car's far side turns by 2 rad/s, those after it by nothing. The slope of the depth's error stays,
// so the first one's should be seen again. That it is not tells that the first fit was wrong, not that the car turns.
TEST(Belief, NoRotationAfterAWrongOneIsNoEvidenceOfTurning) {
  MotionEstimate e = fit({0, 0, 0}, 0.3);
  e.range = 27;
  e.inertia.diagonal() << 2.1, 2.2, 0.2;
  e.angular_velocity << -1.4, 0.2, 1.5;
  e.angular_covariance = 0.2 * 0.2 * I;
  Belief belief;
  belief.update(e, settings.v0_at(e.range), settings);
  e.angular_velocity.setZero();
  e.angular_covariance.diagonal() << sq(0.02), sq(0.1), sq(0.1);
  for (int i = 0; i < 5; ++i) {
    belief.predict(0.1, I, settings);
    const double before = belief.log_odds;
    belief.update(e, settings.v0_at(e.range), settings);
    EXPECT_LT(belief.log_odds, before) << i;
  }
  EXPECT_LT(belief.log_odds, -2);
}

TEST(Belief, NothingThatIsNotFiniteEnters) {
  Belief belief;
  for (int i = 0; i < 5; ++i) belief.update(fit({3, 0, 0}, 0.2), 0.5, settings);
  const Belief before = belief;
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  std::vector<MotionEstimate> bad;
  for (const double value : {nan, inf, -inf}) {
    bad.push_back(fit({value, 0, 0}, 0.2));
    bad.push_back(fit({3, 0, 0}, 0.2, value));
    bad.push_back(fit({3, 0, 0}, 0.2));
    bad.back().covariance(1, 2) = value;
    bad.push_back(fit({3, 0, 0}, 0.2));
    bad.back().range = value;
    for (int i = 0; i < 3; ++i) bad.push_back(turning_fit(0.6, 0.05));
    bad[bad.size() - 1].angular_velocity[1] = value;
    bad[bad.size() - 2].angular_covariance(1, 1) = value;
    bad[bad.size() - 3].inertia(1, 1) = value;
  }
  bad.push_back(fit({3, 0, 0}, 0.2, 0.1, 0));
  bad.push_back(fit({3, 0, 0}, 0.2));
  bad.back().covariance = -I;  // of no Gaussian
  for (const MotionEstimate& e : bad) {
    belief.update(e, 0.5, settings);
    ASSERT_TRUE(std::isfinite(belief.log_odds) && std::isfinite(belief.p_turning) && belief.velocity.allFinite() &&
                belief.covariance.allFinite());
    if (&e == &bad.back()) break;
    EXPECT_EQ(belief.log_odds, before.log_odds);
    EXPECT_EQ(belief.velocity, before.velocity);
  }
  belief.predict(0.1, I, settings);
  belief.update(fit({3, 0, 0}, 0.2), 0.5, settings);
  EXPECT_GT(belief.p_moving(), 0.9);
}

}  // namespace
