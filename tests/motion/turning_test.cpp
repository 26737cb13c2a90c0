// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dot/lie/so3.hpp"
#include "support/random.hpp"

namespace {

using dot::Matrix3;
using dot::MotionEstimate;
using dot::Turning;
using dot::Vector3;

constexpr double prior = 1;  // rad/s
const Matrix3<double> I = Matrix3<double>::Identity();

MotionEstimate fit(const Vector3<double>& w, double sigma, double seconds = 0.1) {
  MotionEstimate e;
  e.angular_velocity = w;
  e.angular_covariance = sigma * sigma * I;
  e.span_seconds = seconds;
  return e;
}

TEST(Turning, PredictsNothingBeforeTheFirstFit) {
  Turning turning;
  turning.predict(1, I, prior);
  EXPECT_EQ(turning.before(fit({0, 0, 0}, 0.1)), nullptr);
}

TEST(Turning, IsTheMeanOfItsFits) {
  dot::test::Random random(1);
  const Vector3<double> truth(0.1, -0.6, 0.2);
  const double sigma = 0.1;
  int inside = 0;
  constexpr int runs = 300;
  for (int run = 0; run < runs; ++run) {
    Turning turning;
    for (int i = 0; i < 6; ++i) {
      turning.update(fit(truth + random.normal3(sigma), sigma), prior);
      turning.predict(0.1, I, prior);
    }
    const Turning::Rate* rate = turning.before(fit(truth, sigma));
    ASSERT_NE(rate, nullptr);
    // It may change as much between two fits as one is wrong: P = P sigma^2 / (P + sigma^2) + sigma^2.
    EXPECT_NEAR(rate->covariance(1, 1), 1.618 * sigma * sigma, 0.01 * sigma * sigma);
    const Vector3<double> error = rate->mean - truth;
    inside += error.dot(rate->covariance.ldlt().solve(error)) < 7.81;  // 95 % of three degrees of freedom
  }
  EXPECT_GT(inside, 0.93 * runs);  // a truth that does not change is better known than it says
}

// A fit over three frames shares two of them with the fit before.
TEST(Turning, IsComparedWithFitsOfOtherTimes) {
  Turning turning;
  for (int i = 0; i < 9; ++i) {
    MotionEstimate e = fit({0, 0.1 * i, 0}, 0.01, 0.3);
    e.span_frames = 3;
    const Turning::Rate* rate = turning.before(e);
    ASSERT_EQ(rate != nullptr, i >= 3) << i;
    if (rate) {
      EXPECT_GE(rate->age, 0.199) << i;  // a frame before the end of the fit
      EXPECT_LE(rate->mean[1], 0.1 * (i - 3) + 0.01) << i;
    }
    turning.update(e, prior);
    turning.predict(0.1, I, prior);
  }
}

TEST(Turning, DoesNotDependOnTheFrameRate) {
  double sigma[2];
  for (const int rate : {10, 60}) {
    Turning turning;
    const double dt = 1.0 / rate;
    for (int i = 0; i < rate; ++i) turning.update(fit({0, 0.5, 0}, 0.05), prior), turning.predict(dt, I, prior);
    const Turning::Rate* known = turning.before(fit({0, 0.5, 0}, 0.05));
    ASSERT_NE(known, nullptr);
    EXPECT_NEAR(known->mean[1], 0.5, 0.005);
    sigma[rate > 10] = std::sqrt(known->covariance(1, 1));
  }
  EXPECT_NEAR(sigma[1], sigma[0], 0.15 * sigma[0]);
}

// Frames that come early and late: neighbours do not overlap.
TEST(Turning, TakesEachFitOfAClockThatJitters) {
  Turning turning;
  for (int i = 0; i < 9; ++i) {
    const double dt = i % 2 == 0 ? 0.18 : 0.22;
    const MotionEstimate e = fit({0, 0.1 * i, 0}, 0.01, dt);
    const Turning::Rate* rate = turning.before(e);
    ASSERT_EQ(rate != nullptr, i > 0) << i;
    if (rate) {
      EXPECT_NEAR(rate->mean[1], 0.1 * (i - 1), 0.01) << i;
    }
    turning.update(e, prior);
    turning.predict(dt, I, prior);
  }
}

TEST(Turning, IsGivenInTheNewestCamerasAxes) {
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0.3, -1, 2));
  const Vector3<double> w(0.2, 0.5, -0.1);
  Turning turning;
  MotionEstimate e = fit(w, 0.01);
  e.angular_covariance(2, 2) = 1;  // not isotropic
  turning.update(e, prior);
  turning.predict(0.1, R, prior);
  Turning still;
  still.update(e, prior);
  still.predict(0.1, I, prior);
  const Turning::Rate *rotated = turning.before(e), *straight = still.before(e);
  ASSERT_TRUE(rotated && straight);
  EXPECT_LT((rotated->mean - R * straight->mean).norm(), 1e-12);
  EXPECT_LT((rotated->covariance - R * straight->covariance * R.transpose()).norm(), 1e-12);
}

TEST(Turning, BeginsAnewWhereAFitContradictsIt) {
  Turning turning;
  for (int i = 0; i < 5; ++i) turning.update(fit({0, 0.9, 0}, 0.02), prior), turning.predict(0.1, I, prior);
  turning.update(fit({0, -0.9, 0}, 0.02), prior);
  turning.predict(0.1, I, prior);
  const Turning::Rate* rate = turning.before(fit({0, 0, 0}, 0.02));
  ASSERT_NE(rate, nullptr);
  EXPECT_NEAR(rate->mean[1], -0.9, 0.01);
}

}  // namespace
