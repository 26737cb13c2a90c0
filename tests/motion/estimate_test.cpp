// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/motion/estimate.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "support/numeric_jacobian.hpp"
#include "support/random.hpp"

namespace {

using dot::Matrix3;
using dot::Matrix6;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using dot::test::matrices_match;
using dot::test::Random;

/// A covariance with correlations, of standard deviations of a millimetre and a milliradian or so.
Matrix6<double> some_covariance(unsigned seed) {
  Random random(seed);
  Matrix6<double> L;
  for (int i = 0; i < 36; ++i) L(i / 6, i % 6) = random.normal(1e-3);
  return L * L.transpose() + 1e-7 * Matrix6<double>::Identity();
}

TEST(Entropy, IsTheFormula) {
  const double two_pi_e = 17.079468445347132;
  EXPECT_NEAR(dot::entropy(Matrix6<double>::Identity()), 3 * std::log(two_pi_e), 1e-12);
  const Matrix6<double> sigma = some_covariance(1);
  EXPECT_NEAR(dot::entropy(sigma), 0.5 * std::log(std::pow(two_pi_e, 6) * sigma.determinant()), 1e-6);
}

TEST(Entropy, IsHighWhenTheMotionIsBadlyDetermined) {
  const Matrix6<double> sigma = some_covariance(2);
  // Ten times the standard deviations: ln 10 for each of the six.
  EXPECT_NEAR(dot::entropy(100 * sigma) - dot::entropy(sigma), 6 * std::log(10.0), 1e-6);
  Matrix6<double> worse = sigma;
  worse(2, 2) *= 4;
  EXPECT_GT(dot::entropy(worse), dot::entropy(sigma));
  EXPECT_TRUE(std::isfinite(dot::entropy(Matrix6<double>::Zero())));
}

const SE3d T_c{dot::so3::exp(Vector3<double>(0.1, -0.3, 0.2)), Vector3<double>(0.4, -0.1, 1.2)};
const Vector3<double> X(3, -1, 14);

/// Where, in the reference's axes, an object seen at X seems to be with an error xi of the camera motion: the image
/// fixes X, and T_c^-1 takes it back.
Vector3<double> seems_at(const Vector6<double>& xi) { return (SE3d::exp(xi) * T_c).inverse() * X; }

/// The shift of the centroid, and the rotation of the object, that the same error seems to be.
Vector6<double> seems_moved(const Vector6<double>& xi) {
  const Matrix3<double> R = (SE3d::exp(xi) * T_c).R;
  Vector6<double> twist;
  twist << seems_at(xi), dot::so3::log(Matrix3<double>(R.transpose() * T_c.R));
  return twist;
}

TEST(CameraShare, FollowsTheDerivative) {
  const Matrix6<double> sigma = some_covariance(3);
  const Matrix6<double> A = dot::test::numeric_jacobian<6>([](const Vector6<double>& xi) { return seems_moved(xi); },
                                                           Vector6<double>(Vector6<double>::Zero()), 1e-5);
  EXPECT_TRUE(matrices_match(Matrix6<double>(1e6 * dot::camera_share(sigma, T_c, X)),
                             Matrix6<double>(1e6 * A * sigma * A.transpose()), 1e-6));
}

TEST(CameraShare, IsWhatRandomErrorsDo) {
  const Matrix6<double> sigma = some_covariance(4);
  const Matrix6<double> L = sigma.llt().matrixL();
  Random random(5);
  const int n = 20000;
  Matrix3<double> found = Matrix3<double>::Zero();
  for (int i = 0; i < n; ++i) {
    Vector6<double> unit;
    for (int k = 0; k < 6; ++k) unit[k] = random.normal();
    const Vector3<double> d = seems_at(L * unit) - seems_at(Vector6<double>::Zero());
    found += d * d.transpose() / n;
  }
  const Matrix3<double> expected = dot::camera_share(sigma, T_c, X).topLeftCorner<3, 3>();
  // 4 sigma of an estimated variance: sqrt(2 / n) of it each; relative to the largest entry.
  const double scale = 1 / expected.cwiseAbs().maxCoeff();
  EXPECT_TRUE(
      matrices_match(Matrix3<double>(scale * found), Matrix3<double>(scale * expected), 4 * std::sqrt(2.0 / n)));
}

TEST(CameraShare, OfARotationGrowsWithTheRange) {
  Matrix6<double> sigma = Matrix6<double>::Zero();
  sigma.bottomRightCorner<3, 3>() = 1e-6 * Matrix3<double>::Identity();
  const Matrix6<double> near = dot::camera_share(sigma, SE3d{}, Vector3<double>(0, 0, 5));
  const Matrix6<double> far = dot::camera_share(sigma, SE3d{}, Vector3<double>(0, 0, 50));
  EXPECT_NEAR(std::sqrt(near(0, 0)), 5e-3, 1e-9);
  EXPECT_NEAR(std::sqrt(far(0, 0)), 50e-3, 1e-9);
  EXPECT_NEAR(far(2, 2), 0, 1e-12);  // along the ray a turn does nothing
}

/// Points on a box about a centre, and their velocities under a motion.
struct MovingPoints {
  dot::PointSet points;
  Vector3<double> centre{0.2, -0.1, 2};
  std::vector<Vector3<double>> offsets;

  explicit MovingPoints(unsigned seed) {
    Random random(seed);
    for (int i = 0; i < 50; ++i)
      for (const double sign : {-1.0, 1.0}) {  // their mean is the centre
        if (sign < 0)
          offsets.push_back({0.1 * random.normal(), 0.2 * random.normal(), 0.05 * random.normal()});
        else
          offsets.push_back(-offsets.back());
        const Vector3<double> at = centre + offsets.back();
        points.push(0, 0, static_cast<float>(at.x() / at.z()), static_cast<float>(at.y() / at.z()),
                    static_cast<float>(1 / at.z()), 0);
      }
  }
};

TEST(PointSpeed, IsTheRootMeanSquareOverThePoints) {
  const MovingPoints body(3);
  dot::MotionEstimate e;
  e.velocity = {0.1, -0.05, 0.2};
  e.angular_velocity = {0.5, -1, 0.3};
  e.inertia = dot::inertia_of(body.points, body.centre);
  double sum = 0;
  for (const Vector3<double>& r : body.offsets) sum += (e.velocity + e.angular_velocity.cross(r)).squaredNorm();
  EXPECT_NEAR(e.point_speed(), std::sqrt(sum / static_cast<double>(body.offsets.size())), 1e-5);
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0.3, 1, -0.5));
  EXPECT_NEAR(e.rotated(R).point_speed(), e.point_speed(), 1e-12);
  e.velocity.setZero(), e.angular_velocity.setZero();
  EXPECT_EQ(e.point_speed(), 0);
}

TEST(PointSpeed, SigmaIsTheErrorOfTheirVelocities) {
  const MovingPoints body(4);
  dot::MotionEstimate e;
  e.covariance = Vector3<double>(1e-4, 4e-4, 9e-4).asDiagonal();
  e.angular_covariance = Vector3<double>(0.01, 0.04, 0.02).asDiagonal();
  e.inertia = dot::inertia_of(body.points, body.centre);
  Random random(5);
  const int n = 4000;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    Vector3<double> v, w;
    for (int i = 0; i < 3; ++i) {
      v[i] = random.normal(std::sqrt(e.covariance(i, i)));
      w[i] = random.normal(std::sqrt(e.angular_covariance(i, i)));
    }
    for (const Vector3<double>& r : body.offsets)
      sum += (v + w.cross(r)).squaredNorm() / n / static_cast<double>(body.offsets.size());
  }
  EXPECT_NEAR(e.point_speed_sigma() / std::sqrt(sum), 1, 0.03);
  const Matrix3<double> R = dot::so3::exp(Vector3<double>(0.3, 1, -0.5));
  EXPECT_NEAR(e.rotated(R).point_speed_sigma(), e.point_speed_sigma(), 1e-12);
  e.depth_covariance = 0.5 * e.covariance;  // turns with it
  EXPECT_TRUE(e.rotated(R).depth_covariance.isApprox(0.5 * e.rotated(R).covariance, 1e-12));
}

TEST(PointSpeed, WithoutPointsIsThatOfTheCentroid) {
  EXPECT_TRUE(dot::inertia_of({}, Vector3<double>(0, 0, 1)).isZero());
  dot::MotionEstimate e;
  e.velocity = {3, 4, 0};
  e.angular_velocity = {9, 9, 9};
  EXPECT_EQ(e.point_speed(), 5);
}

}  // namespace
