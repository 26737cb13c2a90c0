// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/last_interval.hpp"

#include <gtest/gtest.h>

#include "support/numeric_jacobian.hpp"
#include "support/object_fit.hpp"

namespace {

using dot::Matrix6;
using dot::ObjectFit;
using dot::over_last_interval;
using dot::SE3d;
using dot::shrink_rotation;
using dot::Vector3;
using dot::Vector6;
using dot::test::any_covariance;
using dot::test::camera_at;
using dot::test::dt;
using dot::test::pose;

/// An object that moves on by W, world axes, in each interval, as an exact fit over the last `span` of three intervals
/// tells it.
struct Moved {
  SE3d W, T_prev_ref;
  Vector3<double> centroid;  ///< at the fit's beginning, reference camera's axes
  ObjectFit fit;

  Moved(const SE3d& step, int span, const Vector3<double>& centroid_world) : W(step) {
    const SE3d reference = camera_at(3 - span);
    T_prev_ref = camera_at(2).inverse() * reference;
    centroid = reference.inverse() * centroid_world;
    SE3d moved;
    for (int i = 0; i < span; ++i) moved = W * moved;
    fit.reason = dot::Reason::None;
    fit.T_o = reference.inverse() * moved * reference;
    fit.sigma = any_covariance<6>(1);
    fit.phi = 0.97;
    fit.n_points = 200;
    fit.n_inliers = 180;
    fit.motion.span_seconds = span * dt;
    fit.motion.span_frames = span;
    fit.motion.range = 8;
    fit.motion.entropy = -30;
    fit.motion.velocity = (fit.T_o * centroid - centroid) / (span * dt);
    fit.motion.covariance = any_covariance<3>(2);
  }
  /// T_o of the last interval, previous camera's axes.
  SE3d last() const { return camera_at(2).inverse() * W * camera_at(2); }
};

const Vector3<double> place(1.5, 0.8, 8);

const double photometric_scale = dot::VelocitySettings{}.photometric_scale;
const dot::MotionPriorSettings prior;

TEST(OverLastInterval, IsTheMotionOfThatInterval) {
  for (const int span : {2, 3})
    for (const SE3d& step : {SE3d::translation({0.2, 0, 0.05}), pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1})}) {
      const Moved object(step, span, place);
      const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, 0);
      EXPECT_TRUE(out.ok());
      const Vector6<double> error = (out.T_o * object.last().inverse()).log();
      EXPECT_LT(error.norm(), 1e-12) << span;
    }
}

// Without rotation the mean over the span is that of each interval.
TEST(OverLastInterval, VelocityIsInThePreviousCamerasAxes) {
  const Moved object(SE3d::translation({0.2, 0, 0.05}), 3, place);
  const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, 0);
  const Vector3<double> before = camera_at(2).inverse() * (object.W * (object.W * place));
  const Vector3<double> velocity = (object.last() * before - before) / dt;
  EXPECT_LT((out.motion.velocity - velocity).norm(), 1e-12);
  EXPECT_GT((out.motion.velocity - object.fit.motion.velocity).norm(), 0.1);  // the axes do differ
}

// Along any direction of the world the velocity is as uncertain as before, apart from what it may have changed: .15 of
// the acceleration times the time that the span has beyond the interval.
TEST(OverLastInterval, SigmaGrowsWithTheSpan) {
  const double acceleration = 2;
  for (const int span : {2, 3}) {
    const Moved object(SE3d::translation({0.2, 0, 0.05}), span, place);
    const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, acceleration);
    const double changed = 0.15 * acceleration * (span - 1) * dt;
    for (const Vector3<double>& axis : {Vector3<double>(1, 0, 0), Vector3<double>(0, 1, 0), Vector3<double>(0, 0, 1),
                                        Vector3<double>(0.6, 0, 0.8), Vector3<double>(0, 0.6, -0.8)}) {
      const Vector3<double> then = camera_at(3 - span).R.transpose() * axis, now = camera_at(2).R.transpose() * axis;
      EXPECT_NEAR(now.dot(out.motion.covariance * now),
                  then.dot(object.fit.motion.covariance * then) + changed * changed, 1e-12)
          << span;
    }
  }
}

// Its Sigma_x is that of the fit, propagated: a standing object's error x of T_o about the centroid becomes a share of
// it about the same place.
TEST(OverLastInterval, PropagatesSigma) {
  const Moved object(SE3d{}, 3, place);
  const SE3d to_centroid = SE3d::translation(object.centroid);
  const SE3d to_centroid_now = SE3d::translation(camera_at(2).inverse() * place);
  const auto error_of = [&](const Vector6<double>& x) -> Vector6<double> {
    ObjectFit wrong = object.fit;
    wrong.T_o = to_centroid * SE3d::exp(x) * to_centroid.inverse() * object.fit.T_o;
    const ObjectFit out = over_last_interval(wrong, object.T_prev_ref, dt, 0);
    return (to_centroid_now.inverse() * out.T_o * to_centroid_now).log();
  };
  const Vector6<double> zero = Vector6<double>::Zero();
  const Matrix6<double> J = dot::test::numeric_jacobian<6>(error_of, zero, 1e-5);
  const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, 0);
  EXPECT_TRUE(dot::test::matrices_match(out.sigma, J * object.fit.sigma * J.transpose(), 1e-10));
  EXPECT_NEAR(out.sigma.trace(), object.fit.sigma.trace() / 9, 1e-9);
}

// What the fit says of itself is not of the last interval.
TEST(OverLastInterval, KeepsWhatTheFitSaysOfItself) {
  const Moved object(pose({0, 0.05, 0}, {0.1, 0, 0}), 3, place);
  const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, 0);
  EXPECT_EQ(out.phi, object.fit.phi);
  EXPECT_EQ(out.n_points, object.fit.n_points);
  EXPECT_EQ(out.n_inliers, object.fit.n_inliers);
  EXPECT_EQ(out.motion.span_seconds, object.fit.motion.span_seconds);
  EXPECT_EQ(out.motion.span_frames, object.fit.motion.span_frames);
  EXPECT_EQ(out.motion.range, object.fit.motion.range);
  EXPECT_EQ(out.motion.entropy, object.fit.motion.entropy);
}

TEST(OverLastInterval, AFitOverItIsReturnedUnchanged) {
  const Moved object(pose({0.1, 0.3, -0.2}, {0.4, 0.1, -0.2}), 1, place);
  const ObjectFit out = over_last_interval(object.fit, object.T_prev_ref, dt, 0);
  EXPECT_EQ(out.T_o.R, object.fit.T_o.R);
  EXPECT_EQ(out.T_o.t, object.fit.T_o.t);
  EXPECT_EQ(out.sigma, object.fit.sigma);
  EXPECT_EQ(out.motion.velocity, object.fit.motion.velocity);
  EXPECT_EQ(out.motion.covariance, object.fit.motion.covariance);
}

// The rotation that is most likely under the prior and the fit's errors, which are `photometric_scale` times what the
// fit says: the minimum of w' P^-1 w + (w - w_fit)' S^-1 (w - w_fit).
TEST(ShrinkRotation, IsTheMeanOfPriorAndFit) {
  const Moved object(pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1}), 1, place);
  const SE3d out = shrink_rotation(object.fit.T_o, object.fit, object.centroid, dt, photometric_scale, prior);
  EXPECT_LT((out * object.centroid - object.fit.T_o * object.centroid).norm(), 1e-12) << "the centre moves as before";

  const dot::Matrix3<double> S = photometric_scale * object.fit.sigma.bottomRightCorner<3, 3>();
  const double turn = prior.rotation * dt;
  const Vector3<double> w = dot::so3::log(out.R), w_fit = dot::so3::log(object.fit.T_o.R);
  const Vector3<double> gradient = w / (turn * turn) + S.inverse() * (w - w_fit);
  EXPECT_LT(gradient.norm(), 1e-9 * (w_fit / (turn * turn)).norm());
  EXPECT_GT((w - w_fit).norm(), 0.01 * w_fit.norm());
}

TEST(ShrinkRotation, ASureFitStaysAndAnUnsureOneDoesNotTurn) {
  Moved object(pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1}), 1, place);
  const Matrix6<double> I = Matrix6<double>::Identity();
  object.fit.sigma = 1e-16 * I;
  SE3d out = shrink_rotation(object.fit.T_o, object.fit, object.centroid, dt, photometric_scale, prior);
  EXPECT_LT((out * object.fit.T_o.inverse()).log().norm(), 1e-9);
  object.fit.sigma = 1e9 * I;
  out = shrink_rotation(object.fit.T_o, object.fit, object.centroid, dt, photometric_scale, prior);
  EXPECT_LT(dot::so3::log(out.R).norm(), 1e-9);
  EXPECT_LT((out.t - (object.fit.T_o * object.centroid - object.centroid)).norm(), 1e-9);
}

}  // namespace
