// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/bias_learning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "dot/camera/pinhole.hpp"
#include "dot/tracker.hpp"
#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::Alignment;
using dot::AlignProblem;
using dot::AlignSettings;
using dot::DepthBias;
using dot::DepthBiasLearning;
using dot::DirectAligner;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

const Pinhole camera(small_camera());
const double pixel = 1 / (camera.intrinsics().fx * camera.intrinsics().baseline);  ///< of disparity, 1/m

/// Of an error of up to a pixel and a half where points are, as of lenses that are a little off.
DepthBias lenses() {
  DepthBias bias;
  bias.coefficients << 0.1, -0.4, -0.5, 0.2, -0.3, 0.3, 0.2;
  bias.coefficients *= 1.5 * pixel;
  return bias;
}

/// A yard through which a camera goes, with depth that is wrong by a bias.
struct Walk {
  DepthBias wrong;
  Vector3<double> velocity{0.4, 0, 2};
  double noise = 0;        ///< grey values
  double depth_noise = 0;  ///< pixels of disparity, of single points
  AlignSettings settings;
  DepthBiasLearning learning;

  Walk() { learning.prior = 0.5 * pixel; }

  void run(int frames) {
    Scene scene;
    scene.bodies.push_back(yard(100));
    PointSet points;
    Rendering before;
    for (int i = 0; i < frames; ++i) {
      const SE3d T_cur_prev = SE3d::translation(Vector3<double>(-0.1 * velocity));
      const SE3d T_world_camera = SE3d::translation(Vector3<double>(0.1 * i * velocity));
      Degradation d;
      d.noise = noise;
      d.seed = static_cast<unsigned>(i);
      const Rendering view = degraded(scene.render(camera, T_world_camera), d);
      Pyramid pyramid;
      pyramid.build(std::as_const(view.grey).view(), 3);
      if (i > 0) {
        DirectAligner<> aligner;
        aligner.settings = settings;
        const AlignProblem<Pinhole> problem{points, pyramid, camera};
        Alignment a = aligner.align(problem, {T_cur_prev}, 1);
        aligner.reject_outliers_and_refit(problem, a);
        learning.learn(points, pyramid.levels[0], camera, a, settings, 0.1);
      }
      points = exact_points(
          view, camera, pyramid, 5, [](int, int) { return true; }, 0.1f * static_cast<float>(pixel));
      std::mt19937 random(static_cast<unsigned>(i));
      std::normal_distribution<double> error(0, depth_noise * pixel);
      for (std::size_t k = 0; k < points.q.size(); ++k) {
        if (depth_noise > 0) {
          points.q[k] = std::max(1e-3f, points.q[k] + static_cast<float>(error(random)));
          points.sigma_q[k] = static_cast<float>(depth_noise * pixel);
        }
        const double s = 2 * static_cast<double>(points.u[k]) / camera.width() - 1;
        const double t = 2 * static_cast<double>(points.v[k]) / camera.height() - 1;
        points.q[k] += static_cast<float>(wrong(s, t));
      }
      points.subtract_bias(learning.bias(), camera.width(), camera.height());
    }
  }

  /// Largest error of what was learnt, pixels of disparity, where points were.
  double worst() const {
    double worst = 0;
    for (double s = -0.8; s <= 0.8; s += 0.1)
      for (double t = -0.8; t <= 0.8; t += 0.2)
        worst = std::max(worst, std::abs(learning.bias()(s, t) - wrong(s, t)) / pixel);
    return worst;
  }
};

// The depth alone tells the scale of the motion, and part of a bias looks like another scale: that part is not learnt.
TEST(DepthBiasLearning, FindsWhatIsWrong) {
  Walk walk;
  walk.wrong = lenses();
  const double before = walk.worst();
  ASSERT_GT(before, 1);
  walk.noise = 2;
  walk.run(12);
  EXPECT_LT(walk.worst(), 0.1 * before) << walk.learning.bias().coefficients.transpose() / pixel;
}

TEST(DepthBiasLearning, LeavesAGoodSensorAlone) {
  for (const Vector3<double>& velocity :
       {Vector3<double>(0, 0, 2), Vector3<double>(1, 0, 0), Vector3<double>(0, 0, -3)}) {
    Walk walk;
    walk.noise = 2;
    walk.velocity = velocity;
    walk.run(10);
    EXPECT_TRUE(walk.learning.bias().is_zero()) << walk.learning.bias().coefficients.transpose() / pixel;
  }
}

// Noise of the depth makes the motion seem shorter, and a bias takes up the rest.
TEST(DepthBiasLearning, NothingFromDepthThatIsNoise) {
  Walk walk;
  walk.noise = 2;
  walk.depth_noise = 1.5;
  walk.run(12);
  EXPECT_TRUE(walk.learning.bias().is_zero()) << walk.learning.bias().coefficients.transpose() / pixel;
}

TEST(DepthBiasLearning, NothingWithoutMotion) {
  Walk walk;
  walk.wrong = lenses();
  walk.noise = 2;
  walk.velocity = Vector3<double>::Zero();
  walk.run(6);
  EXPECT_TRUE(walk.learning.bias().is_zero());
}

TEST(DepthBiasLearning, NothingWithoutAPrior) {
  Walk walk;
  walk.wrong = lenses();
  walk.learning.prior = 0;
  walk.run(4);
  EXPECT_TRUE(walk.learning.bias().is_zero());
}

TEST(DepthBiasLearning, Forgets) {
  Walk walk;
  walk.wrong = lenses();
  walk.run(4);
  ASSERT_FALSE(walk.learning.bias().is_zero());
  walk.learning.forget();
  EXPECT_TRUE(walk.learning.bias().is_zero());
}

/// What a tracker makes of a badly calibrated pair: the camera's largest error, metres a frame.
double camera_error(double prior_px) {
  Film<> film;
  film.camera_path = straight({0, 0, -6}, {0, 0, 3});
  film.spoil = [](int, Rendering& seen) {
    const DepthBias bias = lenses();
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (float& z = seen.depth(x, y); z > 0)
          z = static_cast<float>(
              1 / (1 / static_cast<double>(z) + bias(2.0 * x / camera.width() - 1, 2.0 * y / camera.height() - 1)));
  };
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  options.depth_noise.stereo_bias_px = prior_px;
  dot::Tracker tracker(small_camera(), options);
  double worst = 0;
  for (int i = 0; i < 14; ++i) {
    const dot::Result& result = film.next(tracker);
    if (prior_px > 0 && i == 13) {
      EXPECT_NEAR(result.disparity_bias_px, lenses().rms() / pixel, 0.1);
    }
    if (!(prior_px > 0)) {
      EXPECT_EQ(result.disparity_bias_px, 0);
    }
    if (i >= 8) worst = std::max(worst, (SE3d::from_row_major(result.camera.T_cur_prev).t - film.T_c().t).norm());
  }
  return worst;
}

TEST(DepthBiasLearning, SparesTheCameraABadCalibration) {
  const double without = camera_error(0), with = camera_error(0.3);
  EXPECT_GT(without, 0.005);
  EXPECT_LT(with, 0.1 * without);
}

}  // namespace
