// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/reference_error.hpp"

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "dot/lie/so3.hpp"
#include "support/random.hpp"

namespace {

using dot::Matrix3;
using dot::MotionEstimate;
using dot::ReferenceError;
using dot::Vector3;
using dot::test::Random;

constexpr double kFrame = 0.1;  // seconds
const Matrix3<double> I = Matrix3<double>::Identity();

/// A fit over so many frames, less certain along the view; the longer, the more certain.
MotionEstimate fit(const Vector3<double>& velocity, int frames) {
  MotionEstimate e;
  e.velocity = velocity;
  e.covariance = (Vector3<double>(0.2, 0.2, 0.9) / frames).cwiseAbs2().asDiagonal();
  e.span_seconds = kFrame * frames;
  e.span_frames = frames;
  return e;
}

TEST(ReferenceError, IsNotKnownOfAnotherReference) {
  ReferenceError error;
  EXPECT_FALSE(error.before(fit({0, 0, 0}, 1)));
  error.update(fit({0, 0, -2}, 2));
  error.predict(kFrame, I);
  EXPECT_FALSE(error.before(fit({0, 0, 0}, 2)));
  EXPECT_FALSE(error.before(fit({0, 0, 0}, 4)));
  ASSERT_TRUE(error.before(fit({0, 0, 0}, 3)));
  error.predict(2 * kFrame, I);  // frames without a fit
  EXPECT_FALSE(error.before(fit({0, 0, 0}, 3)));
  EXPECT_TRUE(error.before(fit({0, 0, 0}, 5)));
  error.update(fit({0, 0, 0}, 1));
  error.predict(kFrame, I);
  EXPECT_FALSE(error.before(fit({0, 0, 0}, 6)));
  EXPECT_EQ(error.before(fit({0, 0, 0}, 2))->error.norm(), 0);  // the old one is forgotten
}

// Fits to a standing object, each wrong by its own error and by that of the reference: what is said before each of them
// has the covariance that is said, and its mean tells part of the error.
TEST(ReferenceError, IsWhatItsFitsTell) {
  Random random(3);
  constexpr int kRuns = 2000, kFits = 4;
  double nees = 0, without = 0, left = 0;
  for (int run = 0; run < kRuns; ++run) {
    ReferenceError error;
    const Vector3<double> x = random.normal3(1);
    for (int frames = 1; frames <= kFits; ++frames) {
      MotionEstimate e = fit({0, 0, 0}, frames);
      const Vector3<double> sigma = e.covariance.diagonal().cwiseSqrt();
      e.velocity = sigma.cwiseProduct(std::sqrt(ReferenceError::kShare) * x +
                                      std::sqrt(1 - ReferenceError::kShare) * random.normal3(1));
      if (frames == kFits) {
        const std::optional<ReferenceError::Known> known = error.before(e);
        ASSERT_TRUE(known);
        const Vector3<double> d = e.velocity - known->error;
        nees += d.dot((e.covariance - known->less).ldlt().solve(d)) / 3;
        left += d.cwiseQuotient(sigma).squaredNorm() / 3;
        without += e.velocity.cwiseQuotient(sigma).squaredNorm() / 3;
      }
      error.update(e);
      error.predict(kFrame, I);
    }
  }
  EXPECT_NEAR(nees / kRuns, 1, 0.05);
  EXPECT_NEAR(without / kRuns, 1, 0.05);
  // Of kShare, three fits leave kShare (1 - kShare) / (1 + 2 kShare).
  const double share = ReferenceError::kShare, unknown = share * (1 - share) / (1 + 2 * share);
  EXPECT_NEAR(left / kRuns, 1 - share + unknown, 0.04);
}

// Three fits within a tenth of a second tell as much as one.
TEST(ReferenceError, IsTheSameAtAnyFrameRate) {
  const auto after = [](int rate) {
    ReferenceError error;
    MotionEstimate e = fit({0.3, -0.1, 2}, 1);
    for (int frames = 1; frames <= rate / 10; ++frames) {
      e.span_seconds = 1.0 * frames / rate;
      e.span_frames = frames;
      error.update(e);
      error.predict(1.0 / rate, I);
    }
    e.span_seconds += 1.0 / rate;
    e.span_frames += 1;
    return *error.before(e);
  };
  const ReferenceError::Known slow = after(10);
  EXPECT_GT(slow.error.z(), 0.3);
  for (const int rate : {30, 60}) {
    EXPECT_LT((after(rate).error - slow.error).norm(), 1e-9) << rate;
    EXPECT_LT((after(rate).less - slow.less).norm(), 1e-9) << rate;
  }
}

TEST(ReferenceError, TurnsWithTheCamera) {
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0.2, -0.7, 0.4));
  ReferenceError error, turned;
  MotionEstimate e = fit({0.3, -0.1, 2}, 1), longer = fit({0, 0, 0}, 2);
  error.update(e);
  turned.update(e);
  error.predict(kFrame, I);
  turned.predict(kFrame, R);
  const ReferenceError::Known known = *error.before(longer), rotated = *turned.before(longer.rotated(R));
  EXPECT_LT((rotated.error - R * known.error).norm(), 1e-9);
  EXPECT_LT((rotated.less - R * known.less * R.transpose()).norm(), 1e-9);
}

}  // namespace
