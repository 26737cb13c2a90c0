// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/displacement_covariance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dot/camera/depth_noise.hpp"
#include "dot/statistics/median.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::Matrix3;
using dot::Matrix6;
using dot::SE3d;
using dot::Vector3;

/// An object 2 m away beside the axis, seen by a camera that turns away from it, and a fit of it that is known to 1 mm.
struct Fit {
  dot::ObjectReference reference;
  dot::CameraSince camera;
  dot::Alignment alignment;
  double sharper = 1;  ///< see SharperImage
  const dot::DepthNoise noise{{}, dot::test::small_camera()};

  Fit() {
    reference.centroid = {0.6, 0.2, 2};
    reference.area = 4000;
    reference.inertia.diagonal() << 0.01, 0.01, 0.02;  // flat, .1 m to each side
    camera.T_now_ref = SE3d{dot::so3::exp(Vector3<double>(0, 0.1, 0)), Vector3<double>(0, 0, -0.2)};
    alignment.covariance.setIdentity();
    alignment.covariance *= 1e-6;
    alignment.with_depth = 200;
  }

  dot::DisplacementCovariance covariances() const {
    return displacement_covariance(dot::ReferencePair{reference, camera, 0.1}, alignment, reference.centroid, {}, noise,
                                   sharper);
  }
  Matrix6<double> covariance() const { return covariances().all; }
  /// Covariance of the centroid, where the measured inverse depth differs by so much from the predicted one.
  Matrix3<double> with_shift(double per_metre) {
    alignment.depth_shift = per_metre;
    alignment.depth_scatter = dot::kSigmaOfMedian * std::abs(per_metre);
    return covariance().topLeftCorner<3, 3>();
  }
  /// Covariance of the rotation, where the differences scatter by so much.
  Matrix3<double> with_spread(double per_metre) {
    alignment.depth_spread = per_metre;
    return covariance().bottomRightCorner<3, 3>();
  }
  double pixel_sigma() const { return noise.pixel_sigma(1 / reference.centroid.z()); }
};

TEST(DisplacementCovariance, NamesThePartOfTheDepth) {
  Fit fit;
  EXPECT_TRUE(fit.covariances().of_depth.isZero(0));
  const Matrix6<double> without = fit.covariance();
  fit.alignment.depth_modes[0] << 0, 0, 0.3, 0, 0, 0, 0, 0;
  const dot::DisplacementCovariance with = fit.covariances();
  EXPECT_GT(with.of_depth(2, 2), 1e-8);
  EXPECT_TRUE(with.all.isApprox(without + with.of_depth, 1e-9));
  fit.alignment.depth_modes[3] << 0, 0, 0.1, 0, 0, 0, 0, 0;  // what changes from frame to frame does not last
  EXPECT_TRUE(fit.covariances().of_depth.isApprox(with.of_depth, 1e-9));
}

TEST(DisplacementCovariance, HasTheFactorOfASharperImageOnItsPhotometricPartAlone) {
  Fit fit;
  const Matrix6<double> photometric = fit.covariance();
  fit.alignment.depth_modes[0] << 0, 0, 0.3, 0, 0, 0, 0, 0;
  fit.sharper = 4;
  const dot::DisplacementCovariance blurred = fit.covariances();
  EXPECT_TRUE(blurred.all.isApprox(4 * photometric + blurred.of_depth, 1e-9));
}

TEST(DisplacementCovariance, GrowsAlongTheRayByADepthThatContradictsTheFit) {
  for (const double metres : {0.3, -0.3}) {
    Fit fit;
    const SE3d& T = fit.camera.T_now_ref;
    const Vector3<double> now = T * fit.reference.centroid;
    const double shift = 1 / (now.z() + metres) - 1 / now.z();
    const Matrix3<double> growth = fit.with_shift(shift) - fit.with_shift(0);
    const Vector3<double> ray = (T.R.transpose() * now).normalized(), across = ray.unitOrthogonal();
    const double along = std::sqrt(ray.dot(growth * ray)), expected = std::abs(shift) * now.z() * now.norm();
    EXPECT_NEAR(along, expected, 0.02 * expected);
    EXPECT_NEAR(across.dot(growth * across), 0, 1e-12);
    EXPECT_NEAR((growth * ray).cross(ray).norm(), 0, 1e-12);
  }
}

TEST(DisplacementCovariance, DoesNotGrowByADepthThatItsNoiseExplains) {
  Fit fit;
  const Matrix3<double> without = fit.with_shift(0);
  const double explained = fit.noise.shared_drift_sigma(1 / fit.reference.centroid.z());
  ASSERT_GT(explained, 0);
  EXPECT_EQ(fit.with_shift(0.9 * explained), without);
  EXPECT_EQ(fit.with_shift(-0.9 * explained), without);
  EXPECT_GT(fit.with_shift(10 * explained).trace(), without.trace());
}

// The median of a few depths scatters more than that of many.
TEST(DisplacementCovariance, GrowsLessByTheMedianOfAFewDepths) {
  Fit fit;
  const double shift = 5 * fit.pixel_sigma();
  const double many = fit.with_shift(shift).trace();
  fit.alignment.with_depth = 1;
  EXPECT_LT(fit.with_shift(shift).trace(), many);
}

// A depth that scatters by s metres over an object of half the width x may be a rotation of s / x.
TEST(DisplacementCovariance, OfTheRotationGrowsByADepthThatScattersMuch) {
  Fit fit;
  const Matrix3<double> without = fit.with_spread(0);
  EXPECT_EQ(fit.with_spread(2 * fit.pixel_sigma()), without);
  const Vector3<double> now = fit.camera.T_now_ref * fit.reference.centroid;
  const Vector3<double> ray = (fit.camera.T_now_ref.R.transpose() * now).normalized(), across = ray.unitOrthogonal();
  const double spread = 20 * fit.pixel_sigma(), lateral = std::sqrt(ray.dot(fit.reference.inertia * ray) / 2);
  const Matrix3<double> growth = fit.with_spread(spread) - without;
  const double turn = spread * now.z() * now.z() / lateral;
  EXPECT_NEAR(lateral, 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(across.dot(growth * across)), turn, 0.02 * turn);
  EXPECT_NEAR(ray.dot(growth * ray), 0, 1e-9) << "a turn about the ray changes no depth";

  fit.alignment.with_depth = 5;
  EXPECT_EQ(fit.with_spread(spread), without) << "too few depths";
}

// The gradients of points that are close together are taken from the same pixels.
TEST(DisplacementCovariance, OfClosePointsIsLarger) {
  Fit close, apart;
  for (Fit* fit : {&close, &apart})
    for (int i = 0; i < 300; ++i) fit->reference.points.push(0, 0, 0, 0, 0.5f, 0);
  close.reference.area = 2700;
  apart.reference.area = 270000;
  EXPECT_NEAR(close.with_spread(0)(0, 0) / apart.with_spread(0)(0, 0), 3 / (1 + 2 * 0.01), 1e-9);
}

}  // namespace
