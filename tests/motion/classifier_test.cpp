// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/classifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"

/// @file
/// The default classifier as a table of truths: what is the case, how well it is measured, what must be said of it.
/// Noise is drawn from the covariance that the fit states. "The same information" at another frame rate is a variance
/// proportional to the rate: as much is known after a second.

namespace {

using dot::Decision;
using dot::Matrix3;
using dot::MotionEstimate;
using dot::State;
using dot::Vector3;
using dot::VelocityClassifier;
using dot::test::Random;

/// Standard deviation of the velocity of one fit at 10 Hz, m/s: across the ray, and along it.
struct Sigma {
  double across, along;
};

/// An object that is watched at a frame rate.
class Watch {
 public:
  Watch(double rate, unsigned seed, double range = 20) : rate_(rate), range_(range), random_(seed) {}

  Decision see(const Vector3<double>& truth, const Sigma& sigma) {
    const double scale = std::sqrt(rate_ / 10);
    MotionEstimate e = fit(truth, {scale * sigma.across, scale * sigma.along});
    for (int i = 0; i < 3; ++i) e.velocity[i] += random_.normal(std::sqrt(e.covariance(i, i)));
    return take(&e);
  }
  Decision miss() { return take(nullptr); }
  /// A fit that is wrong: this velocity, stated with this sigma.
  Decision mislead(const Vector3<double>& velocity, double sigma) {
    const MotionEstimate e = fit(velocity, {sigma, sigma});
    return take(&e);
  }
  double dt() const { return 1 / rate_; }

 private:
  MotionEstimate fit(const Vector3<double>& velocity, const Sigma& sigma) const {
    MotionEstimate e;
    e.velocity = velocity;
    e.covariance = Vector3<double>(sigma.across, sigma.across, sigma.along).array().square().matrix().asDiagonal();
    e.span_seconds = dt();
    e.range = range_;
    return e;
  }
  Decision take(const MotionEstimate* e) { return classifier_(memory_, e, Matrix3<double>::Identity(), dt()); }

  VelocityClassifier classifier_;
  VelocityClassifier::Memory memory_;
  double rate_, range_;
  Random random_;
};

/// Shares of the frames of `seconds` in each state, over many objects.
struct Shares {
  double still = 0, moving = 0, undecided = 0;
};

Shares watch(double rate, double seconds, const Vector3<double>& truth, const Sigma& sigma, double range = 20,
             double from = 0) {
  Shares shares;
  int frames = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    Watch object(rate, seed, range);
    for (int i = 0; i < seconds * rate; ++i) {
      const State state = object.see(truth, sigma).state;
      if (i * object.dt() < from) continue;
      ++frames;
      shares.still += state == State::Static;
      shares.moving += state == State::Moving;
      shares.undecided += state == State::NotObservable;
    }
  }
  return {shares.still / frames, shares.moving / frames, shares.undecided / frames};
}

const Vector3<double> parked = Vector3<double>::Zero();
constexpr double kRates[] = {5, 10, 30};

TEST(VelocityClassifier, ParkedIsNotMovingHoweverItIsMeasured) {
  for (const double rate : kRates)
    for (const Sigma& sigma : {Sigma{0.05, 0.1}, Sigma{0.1, 0.5}, Sigma{0.2, 1}, Sigma{0.1, 3}, Sigma{0.3, 10},
                               Sigma{0.1, 20}, Sigma{1, 20}, Sigma{5, 5}, Sigma{20, 20}}) {
      EXPECT_LT(watch(rate, 2, parked, sigma).moving, 0.02) << rate << " Hz, " << sigma.across << ", " << sigma.along;
    }
}

TEST(VelocityClassifier, ParkedAndWellMeasuredIsStaticWithinASecond) {
  for (const double rate : kRates)
    for (const Sigma& sigma : {Sigma{0.05, 0.1}, Sigma{0.1, 0.3}, Sigma{0.1, 0.5}})
      EXPECT_GT(watch(rate, 3, parked, sigma, 20, 1).still, 0.95) << rate << " Hz, " << sigma.along;
}

TEST(VelocityClassifier, MoverIsMovingWithinHalfASecond) {
  for (const double rate : kRates)
    for (const Vector3<double>& v : {Vector3<double>(3, 0, 0), Vector3<double>(0, 0, 8), Vector3<double>(-2, 0, -10),
                                     Vector3<double>(0, 0, -30)}) {
      const Shares shares = watch(rate, 2, v, {0.2, 0.6}, 20, 0.5);
      EXPECT_GT(shares.moving, 0.97) << rate << " Hz, " << v.transpose();
      EXPECT_LT(shares.still, 0.01) << rate << " Hz, " << v.transpose();
    }
}

TEST(VelocityClassifier, ParkedThatDrivesOffFlipsWithinHalfASecond) {
  for (const double rate : {10.0, 30.0})
    for (const Vector3<double>& v : {Vector3<double>(2, 0, 0), Vector3<double>(0, 0, 4)}) {
      int late = 0;
      for (unsigned seed = 0; seed < 100; ++seed) {
        Watch object(rate, seed);
        for (int i = 0; i < 3 * rate; ++i) object.see(parked, {0.1, 0.3});
        State state = State::Static;
        for (int i = 0; i < 0.5 * rate; ++i) state = object.see(v, {0.1, 0.3}).state;
        late += state != State::Moving;
      }
      EXPECT_LE(late, 5) << rate << " Hz, " << v.transpose();
    }
}

TEST(VelocityClassifier, RadialVelocityThatIsNotMeasuredNeverMakesAMover) {
  // The sideways velocity is known to be zero: parked cars and those that come straight at us have that in common.
  for (const double rate : kRates)
    for (const Vector3<double>& v : {parked, Vector3<double>(0, 0, -8), Vector3<double>(0, 0, 12)})
      EXPECT_LT(watch(rate, 1, v, {0.1, 20}).moving, 0.1) << rate << " Hz, " << v.transpose();
}

TEST(VelocityClassifier, WhatComesStraightAtUsIsFoundOutOnceThatIsMeasured) {
  // Whatever a second without radial measurement made of it.
  for (const double rate : kRates) {
    int late = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
      Watch object(rate, seed);
      for (int i = 0; i < rate; ++i) object.see({0, 0, -8}, {0.1, 20});
      State state = State::NotObservable;
      for (int i = 0; i < rate; ++i) state = object.see({0, 0, -8}, {0.1, 1}).state;
      late += state != State::Moving;
    }
    EXPECT_LE(late, 2) << rate << " Hz";
  }
}

TEST(VelocityClassifier, StateOutlivesTheFitsAndFades) {
  for (const double rate : kRates)
    for (const Vector3<double>& v : {Vector3<double>(3, 0, 0), parked}) {
      Watch object(rate, 5);
      Decision d;
      for (int i = 0; i < 3 * rate; ++i) d = object.see(v, {0.1, 0.3});
      const State won = v.norm() > 0 ? State::Moving : State::Static;
      ASSERT_EQ(d.state, won);
      double p = d.p_moving, lasted = 0;
      for (int i = 0; i < 120 * rate; ++i) {
        d = object.miss();
        EXPECT_LT(std::abs(d.p_moving - dot::Belief::kPrior), std::abs(p - dot::Belief::kPrior));
        EXPECT_TRUE(d.state == won || d.state == State::NotObservable);
        p = d.p_moving;
        if (d.state == won) lasted += object.dt();
      }
      EXPECT_GT(lasted, 1);  // longer than an occlusion
      EXPECT_LT(lasted, 30);
      EXPECT_EQ(d.state, State::NotObservable);
    }
}

TEST(VelocityClassifier, FrameRateDoesNotMatter) {
  // Median time until the first decision, which for the same information differs by a frame of 5 Hz or two.
  const auto median_time = [](double rate, const Vector3<double>& v, const Sigma& sigma, State state) {
    std::vector<double> times;
    for (unsigned seed = 0; seed < 101; ++seed) {
      Watch object(rate, seed);
      int i = 1;
      while (object.see(v, sigma).state != state && i < 10 * rate) ++i;
      times.push_back(i * object.dt());
    }
    std::nth_element(times.begin(), times.begin() + 50, times.end());
    return times[50];
  };
  for (const Sigma& sigma : {Sigma{0.1, 0.3}, Sigma{0.2, 0.8}}) {
    const double still = median_time(10, parked, sigma, State::Static);
    const double moving = median_time(10, {0, 0, 5}, sigma, State::Moving);
    for (const double rate : {5.0, 30.0}) {
      EXPECT_NEAR(median_time(rate, parked, sigma, State::Static), still, 0.41) << rate;
      EXPECT_NEAR(median_time(rate, {0, 0, 5}, sigma, State::Moving), moving, 0.41) << rate;
    }
  }
}

TEST(VelocityClassifier, OutlierFitsDoNotFlipAState) {
  for (const double rate : kRates) {
    int flips = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
      Watch still(rate, seed), mover(rate, seed + 1000);
      for (int i = 0; i < 2 * rate; ++i) still.see(parked, {0.1, 0.3}), mover.see({3, 0, 0}, {0.1, 0.3});
      for (int k = 0; k < 4; ++k) {  // one wrong fit every second
        flips += still.mislead({6, 0, -9}, 0.2).state == State::Moving;
        flips += mover.mislead(parked, 0.2).state == State::Static;
        for (int i = 0; i < rate; ++i) {
          flips += still.see(parked, {0.1, 0.3}).state == State::Moving;
          flips += mover.see({3, 0, 0}, {0.1, 0.3}).state == State::Static;
        }
      }
    }
    EXPECT_EQ(flips, 0) << rate;
  }
}

TEST(VelocityClassifier, NearThingsMoveAtLowerSpeeds) {
  const VelocityClassifier classifier;
  EXPECT_DOUBLE_EQ(classifier.v0(1), 0.005);
  EXPECT_DOUBLE_EQ(classifier.v0(4), 0.08);
  EXPECT_DOUBLE_EQ(classifier.v0(10), 0.5);
  EXPECT_DOUBLE_EQ(classifier.v0(80), 0.5);
  EXPECT_GT(classifier.v0(0), 0);
  // A box on a table at 1 m, pushed at 0.2 m/s, and one that stands; far away 0.2 m/s is no motion.
  for (const Vector3<double>& v : {Vector3<double>(0.2, 0, 0), Vector3<double>(0, 0, 0.2)})
    EXPECT_GT(watch(30, 2, v, {0.02, 0.03}, 1, 0.5).moving, 0.95);
  EXPECT_GT(watch(30, 3, parked, {0.02, 0.03}, 1, 1).still, 0.9);
  EXPECT_EQ(watch(30, 2, {0.2, 0, 0}, {0.02, 0.03}, 20).moving, 0);
}

TEST(VelocityClassifier, TellsTheVelocityInTheNewestAxes) {
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0, 0.3, 0));
  const VelocityClassifier classifier;
  VelocityClassifier::Memory memory;
  MotionEstimate e;
  e.velocity = {0, 0, 8};
  e.covariance = 0.01 * Matrix3<double>::Identity();
  e.span_seconds = 0.1;
  e.range = 20;
  const Decision d = classifier(memory, &e, R, 0.1);
  EXPECT_LT((d.velocity - R * e.velocity).norm(), 0.1);
  EXPECT_GT(d.covariance.trace(), 0);
}

}  // namespace
