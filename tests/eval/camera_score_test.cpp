// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/camera_score.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "dot_eval/pose_error.hpp"

namespace eval {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

Eigen::Matrix4d at(double x, double y, double z) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topRightCorner<3, 1>() << x, y, z;
  return T;
}

Eigen::Matrix4d turned(const Eigen::Vector3d& axis, double degrees) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = Eigen::AngleAxisd(degrees * radians_per_degree, axis.normalized()).toRotationMatrix();
  return T;
}

TEST(RotationAngle, IsExactForSmallAndLargeAngles) {
  for (const double degrees : {1e-7, 0.01, 30.0, 179.0})
    EXPECT_NEAR(rotation_angle_deg(turned({1, 2, 3}, degrees).topLeftCorner<3, 3>()), degrees, 1e-9);
}

TEST(MotionError, OfAnObjectSeenByATurnedCamera) {
  // The object drives 1 m along the world's x; the camera looks along it from 5 m behind.
  const Eigen::Matrix4d camera = at(-5, 0, 0) * turned({0, 1, 0}, 90);
  const Eigen::Matrix4d right = camera.inverse() * at(1, 0, 0) * camera;
  EXPECT_NEAR(motion_error(right, camera, at(0, 0, 0), at(1, 0, 0)).metres, 0, 1e-12);
  const MotionError none = motion_error(Eigen::Matrix4d::Identity(), camera, at(0, 0, 0), at(1, 0, 0));
  EXPECT_NEAR(none.metres, 1, 1e-12);
  EXPECT_NEAR(none.degrees, 0, 1e-9);
  // Turning about its own origin moves the origin nowhere.
  const Eigen::Matrix4d turn = camera.inverse() * turned({0, 1, 0}, 2) * camera;
  const MotionError turned_too = motion_error(turn, camera, at(0, 0, 0), at(0, 0, 0));
  EXPECT_NEAR(turned_too.metres, 0, 1e-12);
  EXPECT_NEAR(turned_too.degrees, 2, 1e-9);
}

TEST(CameraScore, PerfectUpToAnotherWorldIsZero) {
  Poses truth, estimate;
  const Eigen::Matrix4d world = at(3, -1, 2) * turned({1, 1, 0}, 40);
  for (int i = 0; i < 5; ++i) {
    truth.push_back(at(0.1 * i * i, 0.01 * i * i * i, i) * turned({0, 1, 0}, 3 * i));
    estimate.push_back(world * truth.back());
  }
  const CameraScore score = score_camera(truth, estimate);
  EXPECT_EQ(score.frames, 5);
  EXPECT_NEAR(score.rpe_trans_max_cm(), 0, 1e-9);
  EXPECT_NEAR(score.rpe_rot_deg(), 0, 1e-9);
  EXPECT_NEAR(score.drift_percent, 0, 1e-9);
  EXPECT_NEAR(score.ate_m, 0, 1e-9);
  EXPECT_FALSE(score.stretch);
}

TEST(CameraScore, StepErrors) {
  // Steps of 1 m, told as 1, 1.01 and 1.03 m.
  const Poses truth{at(0, 0, 0), at(0, 0, 1), at(0, 0, 2), at(0, 0, 3)};
  const Poses estimate{at(0, 0, 0), at(0, 0, 1), at(0, 0, 2.01), at(0, 0, 3.04)};
  const CameraScore score = score_camera(truth, estimate);
  EXPECT_NEAR(score.path_m, 3, 1e-12);
  EXPECT_NEAR(score.rpe_trans_median_cm(), 1, 1e-9);
  EXPECT_NEAR(score.rpe_trans_max_cm(), 3, 1e-9);
  EXPECT_NEAR(score.rpe_trans_cm(), std::sqrt(10.0 / 3), 1e-9);
  EXPECT_NEAR(score.drift_percent, 100 * 0.04 / 3, 1e-9);
  // Distances from the mean: -1.5, -.5, .5, 1.5 against -1.5125, -.5125, .4975, 1.5275.
  EXPECT_NEAR(score.ate_m, std::sqrt((2 * 0.0125 * 0.0125 + 0.0025 * 0.0025 + 0.0275 * 0.0275) / 4), 1e-9);
}

// Errors of two sigmas along each of the six axes, in the axes of the new camera; sigmas of 1 cm and .001.
TEST(CameraScore, NormalisesAnErrorByItsCovariance) {
  using dot::SE3d;
  dot::Vector6<double> sigma, error;
  sigma << 0.01, 0.01, 0.01, 0.001, 0.001, 0.001;
  error << 2, -2, 2, -2, 2, 2;
  const SE3d truth = SE3d::exp((dot::Vector6<double>() << 0.1, 0, 1, 0, 0.05, 0).finished());
  const SE3d estimate = SE3d::exp(error.cwiseProduct(sigma)) * truth;
  const dot::Matrix6<double> covariance = sigma.cwiseAbs2().asDiagonal();
  EXPECT_NEAR(camera_nees(truth, estimate, covariance), 4, 1e-9);
  EXPECT_NEAR(camera_nees(truth, truth, covariance), 0, 1e-9);
  EXPECT_TRUE(std::isnan(CameraScore{}.nees_per_axis()));
}

TEST(CameraScore, AlignmentIsARotationNotAMirror) {
  const Poses truth{at(0, 0, 0), at(1, 0, 0), at(0, 2, 0), at(0, 0, 3)};
  const Poses mirrored{at(0, 0, 0), at(-1, 0, 0), at(0, 2, 0), at(0, 0, 3)};
  EXPECT_GT(score_camera(truth, mirrored).ate_m, 0.1);
}

TEST(CameraScore, StretchesOf100Metres) {
  // 2 % too long, over 121 m in steps of 1 m: stretches of 100 m start in frames 0, 10 and 20.
  Poses truth, estimate;
  for (int i = 0; i <= 121; ++i) {
    truth.push_back(at(0, 0, i));
    estimate.push_back(at(0, 0, 1.02 * i));
  }
  const CameraScore score = score_camera(truth, estimate);
  ASSERT_TRUE(score.stretch);
  EXPECT_EQ(score.stretch->stretches, 3);
  // The stretch ends in the first frame beyond 100 m, hence 101 steps.
  EXPECT_NEAR(score.stretch->translation_percent, 2 * 1.01, 1e-9);
  EXPECT_NEAR(score.stretch->rotation_deg_per_100m, 0, 1e-9);
}

}  // namespace
}  // namespace eval
