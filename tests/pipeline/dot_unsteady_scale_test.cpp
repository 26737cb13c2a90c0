// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Depth of a network: its scale differs from frame to frame.

#include <gtest/gtest.h>

#include <cmath>

#include "dot/tracker.hpp"
#include "support/film.hpp"
#include "support/random.hpp"

namespace {

using dot::CameraStatus;
using dot::Result;
using dot::Suspicion;
using dot::Tracker;
using namespace dot::test;

/// What the answers of 30 frames are worth whose depth has a scale of its own in each frame.
struct Answers {
  double error = 0;     ///< squared, of the camera's way along its motion, m^2, mean over the frames from the tenth on
  double variance = 0;  ///< as the covariance says, likewise
  int suspected = 0;    ///< frames with the suspicion that the scale is unsteady
  double figure = 0;    ///< of the last suspicion
  int moving = 0;       ///< frames in which the parked car counts as moving
};

Answers drive(double sigma_of_scale) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {2, 0, 1});
  film.degradation.noise = 1, film.degradation.depth_noise = 0.001;
  film.add(7, straight({3.5, 1.3, 8}));
  Random random(5);
  film.spoil = [&](int, Rendering& seen) {
    const auto scale = static_cast<float>(std::exp(random.normal(sigma_of_scale)));
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x) seen.depth(x, y) *= scale;
  };
  Tracker tracker(small_camera());
  Answers out;
  constexpr int kFrames = 30, kSettled = 10;
  for (int i = 0; i < kFrames; ++i) {
    const Result& result = film.next(tracker);
    if (result.diagnosis.reason == Suspicion::UnsteadyScale) ++out.suspected, out.figure = result.diagnosis.figure;
    for (std::size_t k = 0; k < result.objects.size; ++k) out.moving += result.objects[k].state == dot::State::Moving;
    if (i < kSettled) continue;
    EXPECT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    const Eigen::Vector3d t = film.T_c().t, along = t.normalized();
    const Eigen::Vector3d got(result.camera.T_cur_prev[3], result.camera.T_cur_prev[7], result.camera.T_cur_prev[11]);
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> C(result.camera.covariance.data());
    const double error = along.dot(got - t), variance = along.dot(C.topLeftCorner<3, 3>() * along);
    out.error += error * error / (kFrames - kSettled), out.variance += variance / (kFrames - kSettled);
  }
  return out;
}

TEST(UnsteadyScale, IsInTheCamerasCovarianceAndNamed) {
  for (const double sigma : {0.02, 0.04}) {
    const Answers answers = drive(sigma);
    EXPECT_GT(answers.error, 1e-6) << "the scale is of no consequence here";
    EXPECT_LT(answers.error, 2.5 * answers.variance) << sigma;
    EXPECT_GT(answers.error, 0.25 * answers.variance) << sigma;
    EXPECT_GT(answers.suspected, 10) << sigma;
    EXPECT_NEAR(answers.figure, sigma, 0.5 * sigma);
    EXPECT_EQ(answers.moving, 0) << sigma;
  }
}

TEST(UnsteadyScale, IsNotSuspectedOfASensor) {
  const Answers answers = drive(0);
  EXPECT_EQ(answers.suspected, 0);
  EXPECT_LT(answers.error, 6 * answers.variance);
}

}  // namespace
