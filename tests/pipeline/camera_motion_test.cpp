// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// What is found of the camera's motion while its velocity is unknown, and what is believed.

#include "dot/pipeline/camera_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::Alignment;
using dot::CameraMotionEstimator;
using dot::DirectAligner;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

const Pinhole camera(small_camera());

Pyramid pyramid_of(const Rendering& view) {
  Pyramid pyramid;
  pyramid.build(view.grey.view(), 3);
  return pyramid;
}

/// From standing still at `reference`, without a velocity.
Alignment found(const Rendering& reference, const Rendering& current, double reach) {
  const PointSet points = exact_points(
      reference, camera, pyramid_of(reference), 4, [](int, int) { return true; }, 0.001f);
  DirectAligner<> aligner;
  dot::MinimaWorkspace workspace;
  return CameraMotionEstimator{}.estimate(points, pyramid_of(current), camera, {SE3d{}}, false, reach, aligner,
                                          workspace);
}

class FarForward : public testing::TestWithParam<double> {};

// Of the yard's wall and ground, half is nearer than 10 m.
TEST_P(FarForward, IsFoundWithoutAPrediction) {
  Scene scene;
  scene.bodies.push_back(yard(100));
  const SE3d T_world_camera = SE3d::translation(Vector3<double>(0, 0, GetParam()));
  const Alignment a = found(scene.render(camera, SE3d{}), scene.render(camera, T_world_camera), 18);
  EXPECT_LT((a.state.T.t + T_world_camera.t).norm(), 0.01 * std::abs(GetParam()));
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
}

INSTANTIATE_TEST_SUITE_P(Metres, FarForward, testing::Values(0.5, 3.0, 6.0, -3.0));

/// A wall 5 m away whose pattern repeats every 24 pixels, moved to the left by `shift` of that, and over it one that
/// does not repeat.
Rendering tiles(double shift, double contrast_of_the_rest) {
  const Texture rest(7, 1, 4, contrast_of_the_rest);
  Rendering view;
  view.intensity.resize(camera.width(), camera.height());
  view.depth.resize(camera.width(), camera.height());
  const double k = 6.283185307179586 / 24;
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const double u = x + 24 * shift;
      const double grey = 128 + 30 * (std::sin(k * u) + std::sin(k * y)) + rest(u / 40, y / 40.0) - 128;
      view.intensity(x, y) = static_cast<float>(grey);
      view.depth(x, y) = 5;
    }
  view.round();
  return view;
}

TEST(AmbiguousMotion, IsNotBelievedUnlessExpected) {
  const Alignment a = found(tiles(0, 0), tiles(0.5, 0), 1);
  EXPECT_LT(a.margin, 0.01) << a.state.T.t.transpose();
  EXPECT_FALSE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, true)) << "phi " << a.phi << " margin " << a.margin;
}

TEST(AmbiguousMotion, IsBelievedWhereSomethingElseTells) {
  const Alignment a = found(tiles(0, 15), tiles(0.4, 15), 1);
  EXPECT_NEAR(a.state.T.t.x(), -0.4 * 24 * 5 / 200, 0.02);
  EXPECT_GT(a.margin, 0.1);
  EXPECT_TRUE(CameraMotionEstimator{}.accepts(a, false)) << "phi " << a.phi << " margin " << a.margin;
}

TEST(Accepts, AsksForABetterCorrelationWithoutAVelocity) {
  const CameraMotionEstimator estimator;
  Alignment a;
  a.seen = 1000, a.inliers = 900;
  a.phi = 0.5 * (estimator.settings.min_phi + estimator.settings.min_phi_unexpected);
  EXPECT_TRUE(estimator.accepts(a, true));
  EXPECT_FALSE(estimator.accepts(a, false));
  a.phi = 0.9;
  EXPECT_TRUE(estimator.accepts(a, false));
  a.inliers = 100;
  EXPECT_FALSE(estimator.accepts(a, true));
}

}  // namespace
