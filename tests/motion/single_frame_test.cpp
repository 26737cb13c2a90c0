// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "dot/motion/classifier.hpp"
#include "support/random.hpp"

/// @file
/// The classifiers without a belief: the paper's entropy rule, and the velocity test of one frame.

namespace {

using dot::Decision;
using dot::EntropyClassifier;
using dot::Matrix3;
using dot::MotionEstimate;
using dot::SingleFrameClassifier;
using dot::State;
using dot::Vector3;

const Matrix3<double> I = Matrix3<double>::Identity();

MotionEstimate fit(double disparity, double disparity_noise, double entropy) {
  MotionEstimate e;
  e.velocity = {1, 0, 2};
  e.covariance = Vector3<double>(0.01, 0.02, 0.3).asDiagonal();
  e.span_seconds = 0.1;
  e.range = 20;
  e.disparity_px = disparity;
  e.disparity_noise_px = disparity_noise;
  e.entropy = entropy;
  return e;
}

EntropyClassifier entropy_rule(bool literal = false) {
  EntropyClassifier c;
  c.settings.max_entropy = -15;
  c.settings.min_entropy = -40;
  c.settings.min_disparity = 1;
  c.settings.noise_factor = 3;
  c.literal = literal;
  return c;
}

/// The decision on an object that was not seen before.
Decision first(const EntropyClassifier& c, const MotionEstimate& e) {
  EntropyClassifier::Memory memory;
  return c(memory, &e, I, 0.1);
}

TEST(EntropyRule, ComparesTheDisparityWithTheNoise) {
  const EntropyClassifier c = entropy_rule();
  EXPECT_EQ(first(c, fit(1.01, 0.1, -30)).state, State::Moving);
  EXPECT_EQ(first(c, fit(0.99, 0.1, -30)).state, State::Static);  // d_min
  EXPECT_EQ(first(c, fit(2.9, 1, -30)).state, State::Static);     // 3 d_noise
  EXPECT_EQ(first(c, fit(3.1, 1, -30)).state, State::Moving);
  EXPECT_EQ(first(c, fit(3.1, 1, -30)).p_moving, 1);
  EXPECT_EQ(first(c, fit(0, 1, -30)).p_moving, 0);
}

TEST(EntropyRule, LeavesOutWhatIsBadlyDetermined) {
  const EntropyClassifier c = entropy_rule();
  for (const double disparity : {0.0, 50.0}) {
    EXPECT_EQ(first(c, fit(disparity, 0.1, -14.9)).state, State::NotObservable);
    EXPECT_EQ(first(c, fit(disparity, 0.1, -14.9)).p_moving, 0.5);
    EXPECT_NE(first(c, fit(disparity, 0.1, -15.1)).state, State::NotObservable);
    EXPECT_NE(first(c, fit(disparity, 0.1, -60)).state, State::NotObservable);  // the better, the better
  }
}

TEST(EntropyRule, LiterallyLeavesOutWhatIsWellDetermined) {
  const EntropyClassifier c = entropy_rule(true);
  EXPECT_EQ(first(c, fit(50, 0.1, -40.1)).state, State::NotObservable);
  EXPECT_EQ(first(c, fit(50, 0.1, -39.9)).state, State::Moving);
  EXPECT_EQ(first(c, fit(0, 0.1, -39.9)).state, State::Static);
  EXPECT_EQ(first(c, fit(50, 0.1, 10)).state, State::Moving);
}

TEST(EntropyRule, KeepsTheLastDecisionOfWhatIsNotObservableNow) {
  const EntropyClassifier c = entropy_rule();
  EntropyClassifier::Memory memory;
  const MotionEstimate moving = fit(9, 0.1, -30), bad = fit(0, 0.1, 0), still = fit(0, 0.1, -30);
  EXPECT_EQ(c(memory, nullptr, I, 0.1).state, State::NotObservable);
  EXPECT_EQ(c(memory, &bad, I, 0.1).state, State::NotObservable);
  EXPECT_EQ(c(memory, &moving, I, 0.1).state, State::Moving);
  EXPECT_EQ(c(memory, &bad, I, 0.1).state, State::Moving);
  EXPECT_EQ(c(memory, nullptr, I, 0.1).state, State::Moving);
  EXPECT_EQ(c(memory, &still, I, 0.1).state, State::Static);
  EXPECT_EQ(c(memory, nullptr, I, 0.1).state, State::Static);
}

TEST(EntropyRule, TellsTheVelocityInTheNewestAxes) {
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0, 0.5, 0));
  const MotionEstimate e = fit(9, 0.1, -30);
  EntropyClassifier::Memory memory;
  const Decision d = entropy_rule()(memory, &e, R, 0.1);
  EXPECT_LT((d.velocity - R * e.velocity).norm(), 1e-12);
  EXPECT_LT((d.covariance - R * e.covariance * R.transpose()).norm(), 1e-12);
}

Decision single(const Vector3<double>& velocity, const Vector3<double>& sigma, double range = 20) {
  MotionEstimate e;
  e.velocity = velocity;
  e.covariance = sigma.array().square().matrix().asDiagonal();
  e.range = range;
  SingleFrameClassifier::Memory memory;
  return SingleFrameClassifier{}(memory, &e, I, 0.1);
}

TEST(SingleFrame, DecidesWhereTheEllipsoidDoes) {
  // The 99 % ellipsoid of three dimensions reaches 3.368 sigma; v0 is 0.5 m/s.
  EXPECT_EQ(single({0.5 + 0.34, 0, 0}, {0.1, 0.1, 0.1}).state, State::Moving);
  EXPECT_EQ(single({0.5 + 0.33, 0, 0}, {0.1, 0.1, 0.1}).state, State::NotObservable);
  EXPECT_EQ(single({0.16, 0, 0}, {0.1, 0.1, 0.1}).state, State::Static);
  EXPECT_EQ(single({0.17, 0, 0}, {0.1, 0.1, 0.1}).state, State::NotObservable);
  EXPECT_EQ(single({0, 0, 0}, {0.01, 0.01, 0.2}).state, State::NotObservable);  // along z it may move
  EXPECT_EQ(single({3, 0, 0}, {0.1, 0.1, 20}).state, State::Moving);            // whatever z does
  EXPECT_EQ(single({0, 0, 30}, {0.1, 0.1, 20}).state, State::NotObservable);
  EXPECT_EQ(single({0.2, 0, 0}, {0.02, 0.02, 0.02}, 1).state, State::Moving);  // v0 is 0.05 m/s at 1 m
}

TEST(SingleFrame, HasNoMemoryAndNoOpinionWithoutAFit) {
  SingleFrameClassifier::Memory memory;
  const Decision d = SingleFrameClassifier{}(memory, nullptr, I, 0.1);
  EXPECT_EQ(d.state, State::NotObservable);
  EXPECT_EQ(d.p_moving, 0.5);
  EXPECT_GT(single({3, 0, 0}, {0.1, 0.1, 0.1}).p_moving, 0.5);
  EXPECT_LT(single({0, 0, 0}, {0.1, 0.1, 0.1}).p_moving, 0.5);
}

TEST(SingleFrame, IsWrongAboutWhatHardlyMovesAtMostInOnePercent) {
  dot::test::Random random(8);
  for (const Vector3<double>& sigma : {Vector3<double>(0.1, 0.1, 0.1), Vector3<double>(0.05, 0.1, 2)})
    for (const Vector3<double>& truth : {Vector3<double>(0.5, 0, 0), Vector3<double>(0.3, 0, 0.4)}) {
      const int n = 4000;
      int moving = 0, still = 0;
      for (int i = 0; i < n; ++i) {
        const Vector3<double> v = truth + random.normal3().cwiseProduct(sigma);
        moving += single(v, sigma).state == State::Moving;
        still += single(v, sigma).state == State::Static;
      }
      EXPECT_LT(moving, 0.01 * n);
      EXPECT_LT(still, 0.01 * n);
    }
}

struct WithoutMemory {
  Decision operator()(int&, const MotionEstimate*, const Matrix3<double>&, double) const { return {}; }
};
struct NotConst {
  struct Memory {};
  Decision operator()(Memory&, const MotionEstimate*, const Matrix3<double>&, double) { return {}; }
};
struct OtherResult {
  struct Memory {};
  State operator()(Memory&, const MotionEstimate*, const Matrix3<double>&, double) const { return {}; }
};

TEST(ClassifierConcept, AcceptsClassifiersAndNothingElse) {
  EXPECT_TRUE(dot::is_classifier_v<dot::VelocityClassifier>);
  EXPECT_TRUE(dot::is_classifier_v<EntropyClassifier>);
  EXPECT_TRUE(dot::is_classifier_v<SingleFrameClassifier>);
  EXPECT_FALSE(dot::is_classifier_v<int>);
  EXPECT_FALSE(dot::is_classifier_v<WithoutMemory>);
  EXPECT_FALSE(dot::is_classifier_v<NotConst>);
  EXPECT_FALSE(dot::is_classifier_v<OtherResult>);
}

TEST(States, HaveNames) {
  EXPECT_EQ(std::string(to_string(State::Background)), "background");
  EXPECT_EQ(std::string(to_string(State::Static)), "static");
  EXPECT_EQ(std::string(to_string(State::Moving)), "moving");
  EXPECT_EQ(std::string(to_string(State::NotObservable)), "unobservable");
  EXPECT_EQ(std::string(to_string(static_cast<State>(9))), "?");
}

}  // namespace
