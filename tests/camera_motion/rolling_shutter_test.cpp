// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/rolling_shutter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "dot/camera/pinhole.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "support/exact_points.hpp"
#include "support/film.hpp"

namespace {

using dot::AlignProblem;
using dot::CameraStep;
using dot::DirectAligner;
using dot::Matrix6;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::RollingShutter;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr double kScale = 4;  ///< CameraSettings::covariance_scale

/// A camera that goes ahead, and whose turn begins at `turning` and changes by `change`, rad/s and rad/s^2.
Path turning_path(const Vector3<double>& turning, const Vector3<double>& change) {
  return [=](double t) {
    return SE3d{dot::so3::exp(Vector3<double>(turning * t + 0.5 * t * t * change)), Vector3<double>(0.1 * t, 0, t)};
  };
}

/// The motion from one frame to the next, aligned and measured.
struct Step {
  CameraStep camera;
  SE3d truth;

  Step(const Path& path, double readout, double noise, unsigned seed = 1) {
    Film<> film;
    film.camera_path = path;
    film.readout = readout;
    film.degradation.noise = noise;
    film.degradation.seed = seed;
    const Pinhole pinhole(small_camera());
    Pyramid before, image;
    film.advance();
    before.build(std::as_const(film.seen().grey).view(), 3);
    const PointSet points = exact_points(film.seen(), pinhole, before, 5, [](int, int) { return true; });
    film.advance();
    image.build(std::as_const(film.seen().grey).view(), 3);
    truth = film.T_c();
    DirectAligner<> aligner;
    const AlignProblem<Pinhole> problem{points, image, pinhole};
    camera.alignment = aligner.align(problem, {truth}, 1);
    aligner.reject_outliers_and_refit(problem, camera.alignment);
    dot::CameraMotionEstimator estimator;
    estimator.settings.covariance_scale = kScale;
    estimator.set_motion(problem, SE3d{}, aligner, camera);
    camera.rolling.is_usual = !camera.rolling.turn.isZero(0);
  }

  const RollingShutter& rolling() const { return camera.rolling; }
  Matrix6<double> of_residuals() const { return kScale * camera.alignment.covariance.topLeftCorner<6, 6>(); }
  Vector6<double> error(const CameraStep& step) const { return (step.T_cur_prev * truth.inverse()).log(); }
  /// Squared error, in sigmas. 16.8 is the 99 % quantile.
  double in_sigmas(const CameraStep& step, const Matrix6<double>& covariance) const {
    return error(step).dot(covariance.ldlt().solve(error(step)));
  }
};

TEST(RollingShutter, MeasuresTheTurnOfTheRowsAndItsPartInTheMotion) {
  constexpr double readout = 0.02, interval = 0.1;
  for (const Vector3<double>& change :
       {Vector3<double>(8, 0, 0), Vector3<double>(0, -8, 0), Vector3<double>(-5, 6, 0), Vector3<double>(0, 0, 12)}) {
    SCOPED_TRACE(change.transpose());
    const Step step(turning_path({0.1, 0.05, 0}, change), readout, 2);
    const Vector3<double> y = -readout * interval * change;
    EXPECT_LT((step.rolling().turn - y).norm(), 0.2 * y.norm()) << step.rolling().turn.transpose();
    EXPECT_GT(step.in_sigmas(step.camera, step.of_residuals()), 5 * 16.8) << "one motion for all rows is wrong";
    EXPECT_LT(step.in_sigmas(step.camera, step.camera.covariance), 16.8);

    const CameraStep middle = step.camera.at_row(0);
    EXPECT_LT(step.in_sigmas(middle, middle.covariance), 16.8);
    EXPECT_LT(step.error(middle).norm(), 0.5 * step.error(step.camera).norm());
    const Path path = turning_path({0.1, 0.05, 0}, change);
    for (const double h : {-0.45, 0.45}) {
      const SE3d truth = path(interval + h * readout).inverse() * path(h * readout);
      const Vector6<double> e = (step.camera.at_row(h).T_cur_prev * truth.inverse()).log();
      const Vector6<double> mean = (step.camera.T_cur_prev * truth.inverse()).log();
      EXPECT_LT(e.tail<3>().norm(), 0.3 * mean.tail<3>().norm()) << h;
    }
  }
}

// A camera that rolls about its axis turns the upper and the lower rows in opposite ways, so T_c takes up nothing of
// it.
TEST(RollingShutter, TurnsRowsAboutTheMiddleOne) {
  const Step step(turning_path({0.1, 0.05, 0}, {0, 0, 12}), 0.02, 2);
  const double turn = std::sqrt(step.rolling().covariance_of_all().bottomRightCorner<3, 3>().trace());
  EXPECT_NEAR(turn / step.rolling().turn.norm(), std::sqrt(1.0 / 12), 0.06);
}

TEST(RollingShutter, IsNotSeenInAGlobalOne) {
  for (unsigned seed = 1; seed <= 8; ++seed)
    for (const double noise : {1.0, 4.0}) {
      const Step step(turning_path({0.1, 0.05, 0}, {8, -4, 3}), 0, noise, seed);
      EXPECT_TRUE(step.rolling().turn.isZero(0)) << step.rolling().turn.transpose();
      EXPECT_EQ(step.camera.covariance, step.of_residuals());
      EXPECT_EQ(step.camera.at_row(0.5).T_cur_prev.t, step.camera.T_cur_prev.t);
      EXPECT_EQ(step.camera.at_row(0.5).covariance, step.camera.covariance);
    }
}

TEST(RollingShutter, DoesNotMatterAtAConstantTurn) {
  const Step step(turning_path({0.3, -0.4, 0.2}, {0, 0, 0}), 0.02, 2);
  EXPECT_TRUE(step.rolling().turn.isZero(0)) << step.rolling().turn.transpose();
}

TEST(RollingShutter, CorrectsNothingAtTheFirstTurn) {
  Step step(turning_path({0.1, 0.05, 0}, {8, 0, 0}), 0.02, 2);
  step.camera.rolling.is_usual = false;
  EXPECT_EQ(step.camera.at_row(0.3).T_cur_prev.t, step.camera.T_cur_prev.t);
  EXPECT_EQ(step.camera.at_row(0.3).covariance, step.camera.covariance);
}

TEST(RollingShutter, NeedsPoints) {
  const Pinhole camera(small_camera());
  const dot::Image<std::uint8_t> image(camera.width(), camera.height());
  const RollingShutter none =
      RollingShutter::measure(PointSet{}, image, camera, dot::Alignment{}, dot::AlignSettings{}, kScale);
  EXPECT_TRUE(none.turn.isZero(0));
  EXPECT_TRUE(none.covariance_of_row(0.5).isZero(0));
  EXPECT_TRUE(none.covariance_of_all().isZero(0));
}

}  // namespace
