// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/pipeline/object_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "support/exact_points.hpp"
#include "support/numeric_jacobian.hpp"
#include "support/random.hpp"

namespace {

using dot::Matrix6;
using dot::ObjectFit;
using dot::ObjectMotionEstimator;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using dot::test::Random;

constexpr double dt = 0.1;

SE3d pose(const Vector3<double>& rotation, const Vector3<double>& place) { return {dot::so3::exp(rotation), place}; }

/// A camera that drives and turns, T_world_camera after n intervals.
SE3d camera_at(int n) { return pose(Vector3<double>(0.02, 0.15, -0.03) * n, Vector3<double>(0.1, -0.02, 0.3) * n); }

template <int N>
Eigen::Matrix<double, N, N> any_covariance(unsigned seed) {
  Random random(seed);
  Eigen::Matrix<double, N, N> A;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) A(r, c) = random.normal(0.05);
  return A * A.transpose();
}

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
    fit.motion.interval = span * dt;
    fit.motion.intervals = span;
    fit.motion.range = 8;
    fit.motion.entropy = -30;
    fit.motion.velocity = (fit.T_o * centroid - centroid) / (span * dt);
    fit.motion.covariance = any_covariance<3>(2);
  }
  /// T_o of the last interval, previous camera's axes.
  SE3d last() const { return camera_at(2).inverse() * W * camera_at(2); }
};

const Vector3<double> place(1.5, 0.8, 8);

TEST(OverLastInterval, IsTheMotionOfThatInterval) {
  for (const int span : {2, 3})
    for (const SE3d& step : {SE3d::translation({0.2, 0, 0.05}), pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1})}) {
      const Moved object(step, span, place);
      const ObjectFit out = ObjectMotionEstimator{}.over_last_interval(object.fit, object.T_prev_ref, dt);
      EXPECT_TRUE(out.ok());
      const Vector6<double> error = (out.T_o * object.last().inverse()).log();
      EXPECT_LT(error.norm(), 1e-12) << span;
    }
}

// Without rotation the mean over the span is that of each interval.
TEST(OverLastInterval, VelocityIsInThePreviousCamerasAxes) {
  const Moved object(SE3d::translation({0.2, 0, 0.05}), 3, place);
  const ObjectFit out = ObjectMotionEstimator{}.over_last_interval(object.fit, object.T_prev_ref, dt);
  const Vector3<double> before = camera_at(2).inverse() * (object.W * (object.W * place));
  const Vector3<double> velocity = (object.last() * before - before) / dt;
  EXPECT_LT((out.motion.velocity - velocity).norm(), 1e-12);
  EXPECT_GT((out.motion.velocity - object.fit.motion.velocity).norm(), 0.1);  // the axes do differ
}

// Along any direction of the world the velocity is as uncertain as before, apart from what it may have changed: .15 of
// the acceleration times the time that the span has beyond the interval.
TEST(OverLastInterval, SigmaGrowsWithTheSpan) {
  ObjectMotionEstimator estimator;
  estimator.velocity.acceleration = 2;
  for (const int span : {2, 3}) {
    const Moved object(SE3d::translation({0.2, 0, 0.05}), span, place);
    const ObjectFit out = estimator.over_last_interval(object.fit, object.T_prev_ref, dt);
    const double changed = 0.15 * 2 * (span - 1) * dt;
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
  const ObjectMotionEstimator estimator;
  const SE3d to_centroid = SE3d::translation(object.centroid);
  const SE3d to_centroid_now = SE3d::translation(camera_at(2).inverse() * place);
  const auto error_of = [&](const Vector6<double>& x) -> Vector6<double> {
    ObjectFit wrong = object.fit;
    wrong.T_o = to_centroid * SE3d::exp(x) * to_centroid.inverse() * object.fit.T_o;
    const ObjectFit out = estimator.over_last_interval(wrong, object.T_prev_ref, dt);
    return (to_centroid_now.inverse() * out.T_o * to_centroid_now).log();
  };
  const Vector6<double> zero = Vector6<double>::Zero();
  const Matrix6<double> J = dot::test::numeric_jacobian<6>(error_of, zero, 1e-5);
  const ObjectFit out = estimator.over_last_interval(object.fit, object.T_prev_ref, dt);
  EXPECT_TRUE(dot::test::matrices_match(out.sigma, J * object.fit.sigma * J.transpose(), 1e-10));
  EXPECT_NEAR(out.sigma.trace(), object.fit.sigma.trace() / 9, 1e-9);
}

// What the fit says of itself is not of the last interval.
TEST(OverLastInterval, KeepsWhatTheFitSaysOfItself) {
  const Moved object(pose({0, 0.05, 0}, {0.1, 0, 0}), 3, place);
  const ObjectFit out = ObjectMotionEstimator{}.over_last_interval(object.fit, object.T_prev_ref, dt);
  EXPECT_EQ(out.phi, object.fit.phi);
  EXPECT_EQ(out.n_points, object.fit.n_points);
  EXPECT_EQ(out.n_inliers, object.fit.n_inliers);
  EXPECT_EQ(out.motion.interval, object.fit.motion.interval);
  EXPECT_EQ(out.motion.intervals, object.fit.motion.intervals);
  EXPECT_EQ(out.motion.range, object.fit.motion.range);
  EXPECT_EQ(out.motion.entropy, object.fit.motion.entropy);
}

TEST(OverLastInterval, AFitOverItIsReturnedUnchanged) {
  const Moved object(pose({0.1, 0.3, -0.2}, {0.4, 0.1, -0.2}), 1, place);
  const ObjectFit out = ObjectMotionEstimator{}.over_last_interval(object.fit, object.T_prev_ref, dt);
  EXPECT_EQ(out.T_o.R, object.fit.T_o.R);
  EXPECT_EQ(out.T_o.t, object.fit.T_o.t);
  EXPECT_EQ(out.sigma, object.fit.sigma);
  EXPECT_EQ(out.motion.velocity, object.fit.motion.velocity);
  EXPECT_EQ(out.motion.covariance, object.fit.motion.covariance);
}

// The rotation that is most likely under the prior and the fit's errors, which are `photometric_scale` times what the
// fit says: the minimum of w' P^-1 w + (w - w_fit)' S^-1 (w - w_fit).
TEST(TurnedSurely, IsTheMeanOfPriorAndFit) {
  ObjectMotionEstimator estimator;
  const Moved object(pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1}), 1, place);
  const SE3d out = estimator.turned_surely(object.fit.T_o, object.fit, object.centroid, dt);
  EXPECT_LT((out * object.centroid - object.fit.T_o * object.centroid).norm(), 1e-12) << "the centre moves as before";

  const dot::Matrix3<double> S = estimator.velocity.photometric_scale * object.fit.sigma.bottomRightCorner<3, 3>();
  const double turn = estimator.prior.rotation * dt;
  const Vector3<double> w = dot::so3::log(out.R), w_fit = dot::so3::log(object.fit.T_o.R);
  const Vector3<double> gradient = w / (turn * turn) + S.inverse() * (w - w_fit);
  EXPECT_LT(gradient.norm(), 1e-9 * (w_fit / (turn * turn)).norm());
  EXPECT_GT((w - w_fit).norm(), 0.01 * w_fit.norm());
}

TEST(TurnedSurely, ASureFitStaysAndAnUnsureOneDoesNotTurn) {
  const ObjectMotionEstimator estimator;
  Moved object(pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1}), 1, place);
  const Matrix6<double> I = Matrix6<double>::Identity();
  object.fit.sigma = 1e-16 * I;
  SE3d out = estimator.turned_surely(object.fit.T_o, object.fit, object.centroid, dt);
  EXPECT_LT((out * object.fit.T_o.inverse()).log().norm(), 1e-9);
  object.fit.sigma = 1e9 * I;
  out = estimator.turned_surely(object.fit.T_o, object.fit, object.centroid, dt);
  EXPECT_LT(dot::so3::log(out.R).norm(), 1e-9);
  EXPECT_LT((out.t - (object.fit.T_o * object.centroid - object.centroid)).norm(), 1e-9);
}

// A fit from the new frame back to the old one, reversed, is that from the old to the new.
TEST(Reversed, IsTheMotionForwards) {
  for (const SE3d& step : {SE3d::translation({0.2, 0, 0.05}), pose({0.01, 0.08, -0.02}, {0.15, 0.02, -0.1})}) {
    const SE3d now = camera_at(3), C = camera_at(2).inverse() * now;
    const Vector3<double> centroid = now.inverse() * (step * place);
    ObjectFit back;
    back.reason = dot::Reason::None;
    back.T_o = now.inverse() * step.inverse() * now;
    back.motion.velocity = (back.T_o * centroid - centroid) / dt;
    back.motion.covariance = any_covariance<3>(3);
    back.sigma = any_covariance<6>(4);
    const ObjectFit out = back.reversed(C);
    EXPECT_TRUE(out.ok());
    const SE3d forwards = camera_at(2).inverse() * step * camera_at(2);
    const Vector6<double> error = (out.T_o * forwards.inverse()).log();
    EXPECT_LT(error.norm(), 1e-12);
    const Vector3<double> before = camera_at(2).inverse() * place;
    EXPECT_LT((out.motion.velocity - (forwards * before - before) / dt).norm(), 1e-12);
    const Vector3<double> along(0.3, -0.5, 0.8);
    EXPECT_NEAR((C.R * along).dot(out.motion.covariance * (C.R * along)), along.dot(back.motion.covariance * along),
                1e-12);

    // A twist x of the motion back about where it leads is one of the motion forwards about where that leads.
    Random random(5);
    Vector6<double> x;
    for (int k = 0; k < 6; ++k) x[k] = random.normal(1e-5);
    const Vector3<double> then = back.T_o * centroid;
    ObjectFit other = back;
    other.T_o = SE3d::translation(then) * SE3d::exp(x) * SE3d::translation(-then) * back.T_o;
    const Vector3<double> moved = C * centroid;
    const SE3d change =
        SE3d::translation(-moved) * other.reversed(C).T_o * out.T_o.inverse() * SE3d::translation(moved);
    ObjectFit of_x = back;
    of_x.sigma = x * x.transpose();
    const Vector6<double> y = change.log();
    EXPECT_LT((of_x.reversed(C).sigma - y * y.transpose()).norm(), 1e-3 * x.squaredNorm());
  }
}

/// A thing of fine texture that moves; the camera stands. Its measured depth scatters about the truth, its points' does
/// not.
struct MovingBox {
  static constexpr int kLevels = 4;
  const dot::Pinhole camera{dot::test::small_camera()};
  const Vector3<double> velocity{2, 0, 0};
  dot::ObjectReference reference;
  dot::Pyramid image;
  dot::DepthPyramid depth;
  dot::Image<std::uint8_t> hidden;

  /// @param scatter 1/m. @param before_it what stands between it and the camera.
  explicit MovingBox(unsigned seed, double scatter = 0, const std::vector<dot::test::Body>& before_it = {}) {
    dot::test::Body body = dot::test::box(7, {0.7, 0.6, 0.4}, seed, 0.07, 0.15, 15);
    body.T_world_body.t = {-0.1, 0, 3.4};
    dot::test::Scene scene{{dot::test::hopper(seed + 20, 1, 2.5, 60), body}};
    scene.bodies.insert(scene.bodies.end(), before_it.begin(), before_it.end());
    const dot::test::Rendering before = scene.render(camera, SE3d{});
    scene.bodies[1].T_world_body.t += velocity * dt;
    const dot::test::Rendering now = scene.render(camera, SE3d{});
    dot::Pyramid pyramid;
    pyramid.build(before.grey.view(), kLevels);
    image.build(now.grey.view(), kLevels);
    dot::Image<float> q = now.inverse_depth();
    Random random(seed);
    for (int y = 0; y < q.height(); ++y)
      for (int x = 0; x < q.width(); ++x) q(x, y) += static_cast<float>(random.normal(scatter));
    depth.build(
        q.width(), q.height(), [&](int y, float* out) { std::copy_n(q.row(y), q.width(), out); }, kLevels);
    hidden.resize(q.width(), q.height());
    hidden.fill(0);
    reference.points = dot::test::exact_points(
        before, camera, pyramid, 4, [&](int x, int y) { return before.ids(x, y) == 7; }, 1e-4f);
    for (std::size_t i = 0; i < reference.points.u.size(); ++i)
      reference.centroid += Vector3<double>(reference.points.x[i], reference.points.y[i], 1) /
                            (static_cast<double>(reference.points.q[i]) * reference.points.size());
    reference.area = 16 * reference.points.size();
    reference.intervals = 1;
  }

  dot::KnownVelocity known() const { return {velocity, 0.01 * dot::Matrix3<double>::Identity(), dt}; }

  ObjectFit fit(const dot::KnownVelocity& known, const std::vector<SE3d>& starts,
                const dot::DepthNoise& noise = {{}, dot::test::small_camera()},
                const ObjectMotionEstimator& estimator = {}) const {
    dot::DirectAligner<> aligner;
    dot::MinimaWorkspace workspace;
    return estimator.fit(reference, dot::ObjectScene<dot::Pinhole>{image, camera, depth, hidden.view()}, starts, known,
                         dt, noise, aligner, workspace);
  }
};

/// That moves out from behind a pillar of coarse, strong texture.
struct HalfHidden : MovingBox {
  explicit HalfHidden(unsigned seed) : MovingBox(seed, 0, {pillar(seed + 40)}) {}

  static dot::test::Body pillar(unsigned seed) {
    dot::test::Body body = dot::test::box(9, {0.35, 1.5, 0.2}, seed, 0.3, 1, 70);
    body.T_world_body.t = {-0.15, 0, 2.2};
    return body;
  }
};

// Coarse levels mix what is seen of it with what stands before it, and stand still with that.
TEST(ObjectFit, StaysWhereTheObjectIsKnownToBe) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const HalfHidden scene(seed);
    const std::vector<SE3d> starts{SE3d::translation(scene.velocity * dt * 1.05)};
    EXPECT_EQ(scene.fit({}, starts).reason, dot::Reason::LowCorrelation) << seed;
    const ObjectFit fit = scene.fit(scene.known(), starts);
    EXPECT_TRUE(fit.ok()) << seed;
    EXPECT_LT((fit.motion.velocity - scene.velocity).norm(), 0.2) << seed;
  }
}

// A car's paint may have four times the noise of the road that taught it: what a fit says of the depth's part of its
// error follows.
TEST(ObjectFit, IsAsUnsureAsItsOwnDepthScatters) {
  ObjectMotionEstimator estimator;
  estimator.velocity.photometric_scale = estimator.velocity.floor = 0;
  dot::DepthNoise noise({}, dot::test::small_camera());
  noise.pixel_scale = noise.common_scale = noise.change_scale = 0.1;
  const double taught = noise.pixel(1 / 3.4);
  const auto sigma = [&](double scatter) {
    const MovingBox scene(1, scatter * taught);
    const ObjectFit fit = scene.fit({}, {SE3d::translation(scene.velocity * dt)}, noise, estimator);
    EXPECT_TRUE(fit.ok()) << scatter;
    return std::sqrt(fit.motion.covariance.trace());
  };
  EXPECT_NEAR(sigma(1) / sigma(0), 1, 0.02);
  EXPECT_GT(sigma(4) / sigma(2), 1.5);
}

// All of them would lie behind the camera.
TEST(ObjectFit, NeedsNoStart) {
  const HalfHidden scene(1);
  EXPECT_EQ(scene.fit(scene.known(), {}).reason, dot::Reason::LeavesImage);
}

}  // namespace
