// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "support/exact_points.hpp"
#include "support/random.hpp"

namespace {

using dot::ObjectFit;
using dot::ObjectMotionEstimator;
using dot::SE3d;
using dot::Vector3;
using dot::test::Random;

constexpr double dt = 0.1;

/// A thing of fine texture that moves; the camera stands. Its measured depth scatters about the truth, its points' does
/// not.
struct MovingBox {
  static constexpr int kLevels = 4;
  const dot::Pinhole camera{dot::test::small_camera()};
  const Vector3<double> velocity{2, 0, 0};
  dot::ObjectReference reference;
  dot::Pyramid image;
  dot::DepthPyramid depth;
  dot::Image<std::uint8_t> occluders;

  /// @param scatter 1/m. @param before_it what stands between it and the camera.
  /// @param turn rad, about the optical axis, in the interval.
  explicit MovingBox(unsigned seed, double scatter = 0, const std::vector<dot::test::Body>& before_it = {},
                     double turn = 0) {
    dot::test::Body body = dot::test::box(7, {0.7, 0.6, 0.4}, seed, 0.07, 0.15, 15);
    body.T_world_body.t = {-0.1, 0, 3.4};
    dot::test::Scene scene{{dot::test::hopper(seed + 20, 1, 2.5, 60), body}};
    scene.bodies.insert(scene.bodies.end(), before_it.begin(), before_it.end());
    const dot::test::Rendering before = scene.render(camera, SE3d{});
    scene.bodies[1].T_world_body.t += velocity * dt;
    scene.bodies[1].T_world_body.R = dot::so3::exp(Vector3<double>(0, 0, turn));
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
    occluders.resize(q.width(), q.height());
    occluders.fill(0);
    reference.points = dot::test::exact_points(
        before, camera, pyramid, 4, [&](int x, int y) { return before.ids(x, y) == 7; }, 1e-4f);
    for (std::size_t i = 0; i < reference.points.u.size(); ++i)
      reference.centroid += Vector3<double>(reference.points.x[i], reference.points.y[i], 1) /
                            (static_cast<double>(reference.points.q[i]) * reference.points.size());
    reference.inertia = dot::inertia_of(reference.points, reference.centroid);
    reference.area = 16 * reference.points.size();
  }

  static dot::CameraSince standing_camera() {
    dot::CameraSince camera;
    camera.intervals = 1;
    return camera;
  }

  dot::KnownVelocity known() const { return {velocity, 0.01 * dot::Matrix3<double>::Identity(), dt}; }

  ObjectFit fit(const dot::KnownVelocity& known, const std::vector<SE3d>& starts,
                const dot::DepthNoise& noise = {{}, dot::test::small_camera()},
                const ObjectMotionEstimator& estimator = {}) const {
    dot::DirectAligner<> aligner;
    dot::MinimaWorkspace workspace;
    const dot::ReferencePair pair{reference, standing_camera(), dt};
    return estimator.fit(pair, dot::ObjectScene<dot::Pinhole>{image, camera, depth, occluders.view()}, starts, known,
                         noise, aligner, workspace);
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

// Of many starts the hopeless ones are left out, wherever the good one stands among them.
TEST(ObjectFit, FindsTheGoodStartAmongMany) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (std::size_t place = 0; place < 4; ++place) {
      const MovingBox scene(seed);
      std::vector<SE3d> starts;
      for (const auto& v : {Vector3<double>(-6, 0, 0), Vector3<double>(0, 4, 2), Vector3<double>(5, -3, -4)})
        starts.push_back(SE3d::translation(v * dt));
      starts.insert(starts.begin() + static_cast<std::ptrdiff_t>(place), SE3d::translation(scene.velocity * dt * 1.05));
      const ObjectFit fit = scene.fit({}, starts);
      EXPECT_TRUE(fit.ok()) << seed << ", " << place << ": " << dot::to_string(fit.reason);
      EXPECT_LT((fit.motion.velocity - scene.velocity).norm(), 0.1) << seed << ", " << place;
    }
}

// The best minimum is refused, because it is too fast. The next one may be taken, but should decide nothing alone. One
// that a known velocity leads to is no doubt.
TEST(ObjectFit, IsDoubtfulIfABetterMinimumWasRefused) {
  ObjectMotionEstimator estimator;
  estimator.settings.min_phi = estimator.settings.min_phi_expected = -1;
  estimator.settings.min_inlier_share = estimator.settings.min_depth_agreement = 0;
  const MovingBox scene(1);
  const dot::DepthNoise noise({}, dot::test::small_camera());
  const std::vector<SE3d> starts{SE3d::translation(scene.velocity * dt),
                                 SE3d::translation(Vector3<double>(-4, -2, 0) * dt)};
  const ObjectFit best = scene.fit({}, starts, noise, estimator);
  ASSERT_TRUE(best.ok());
  EXPECT_LT((best.motion.velocity - scene.velocity).norm(), 0.2);
  EXPECT_FALSE(best.motion.is_doubtful);
  estimator.settings.max_speed = 0.6 * scene.velocity.norm();
  const ObjectFit next = scene.fit({}, starts, noise, estimator);
  ASSERT_TRUE(next.ok()) << dot::to_string(next.reason);
  EXPECT_GT((next.motion.velocity - scene.velocity).norm(), 1);
  EXPECT_TRUE(next.motion.is_doubtful);
  const dot::KnownVelocity known{next.motion.velocity, 0.01 * dot::Matrix3<double>::Identity(), dt};
  const ObjectFit led = scene.fit(known, starts, noise, estimator);
  ASSERT_TRUE(led.ok()) << dot::to_string(led.reason);
  EXPECT_FALSE(led.motion.is_doubtful);
}

// A car's paint may have four times the noise of the road that taught it: what a fit says of the depth's part of its
// error follows.
TEST(ObjectFit, IsAsUnsureAsItsOwnDepthScatters) {
  ObjectMotionEstimator estimator;
  estimator.velocity.photometric_scale = estimator.velocity.floor = 0;
  dot::DepthNoise noise({}, dot::test::small_camera());
  noise.pixel_scale = noise.shared_scale = noise.shared_drift_scale = 0.1;
  const double taught = noise.pixel_sigma(1 / 3.4);
  const auto sigma = [&](double scatter) {
    const MovingBox scene(1, scatter * taught);
    const ObjectFit fit = scene.fit({}, {SE3d::translation(scene.velocity * dt)}, noise, estimator);
    EXPECT_TRUE(fit.ok()) << scatter;
    return std::sqrt(fit.motion.covariance.trace());
  };
  EXPECT_NEAR(sigma(1) / sigma(0), 1, 0.02);
  EXPECT_GT(sigma(4) / sigma(2), 1.5);
}

// With the prior taken out, the rotation is that of the data, and its sigma covers the error.
TEST(ObjectFit, SaysHowItTurns) {
  for (const double speed : {-0.6, 0.0, 0.3, 0.6}) {  // rad/s
    double chi2 = 0, mean = 0;
    const int n = 5;
    for (unsigned seed = 1; seed <= n; ++seed) {
      const MovingBox scene(seed, 0.0005, {}, speed * dt);
      const ObjectFit fit = scene.fit({}, {SE3d::translation(scene.velocity * dt)});
      ASSERT_TRUE(fit.ok()) << speed << ", " << seed << ": " << dot::to_string(fit.reason);
      const Vector3<double> error = fit.motion.angular_velocity - Vector3<double>(0, 0, speed);
      mean += fit.motion.angular_velocity.z() / n;
      chi2 += error.dot(fit.motion.angular_covariance.ldlt().solve(error)) / 3 / n;
    }
    EXPECT_NEAR(mean, speed, 0.01);
    EXPECT_LT(chi2, 1) << speed;
  }
}

// A prior pulls to no rotation. K takes nine tenths of it out.
TEST(WithoutPrior, GivesTheRotationOfTheData) {
  dot::MotionPriorSettings prior;
  const dot::Matrix3<double> P = dot::prior_information(prior, dt).bottomRightCorner<3, 3>();
  dot::Matrix3<double> H;  // information of the data
  H << 900, 100, -50, 100, 400, 30, -50, 30, 20;
  const Vector3<double> measured(0.02, -0.05, 0.03);
  const dot::Matrix3<double> S = (H + P).inverse();
  const Vector3<double> fitted = S * H * measured;
  const Vector3<double> expected = (H + 0.1 * P).inverse() * H * measured;
  EXPECT_LT((dot::without_prior(S, prior, dt) * fitted - expected).norm(), 1e-12);
  EXPECT_TRUE(dot::without_prior(P.inverse(), prior, dt).isApprox(10 * dot::Matrix3<double>::Identity(), 1e-9));
}

// All of them would lie behind the camera.
TEST(ObjectFit, NeedsNoStart) {
  const HalfHidden scene(1);
  EXPECT_EQ(scene.fit(scene.known(), {}).reason, dot::Reason::LeavesImage);
}

}  // namespace
