// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

/// @file
/// Definitions of motion/estimate.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE double entropy(const Matrix6<double>& sigma) {
  const Eigen::LDLT<Matrix6<double>> ldlt(sigma);
  const double log_det = ldlt.vectorD().array().max(1e-300).log().sum();
  return 0.5 * (6 * std::log(2 * 3.14159265358979323846 * 2.71828182845904523536) + log_det);
}

DOT_INLINE Matrix6<double> camera_share(const Matrix6<double>& camera_covariance, const SE3d& T_c,
                                        const Vector3<double>& X) {
  Matrix6<double> A;
  A << T_c.R.transpose(), -T_c.R.transpose() * so3::hat(X), Matrix3<double>::Zero(), T_c.R.transpose();
  return A * camera_covariance * A.transpose();
}

DOT_INLINE double MotionEstimate::point_speed() const {
  return std::sqrt(velocity.squaredNorm() + std::max(0.0, angular_velocity.dot(inertia * angular_velocity)));
}

DOT_INLINE double MotionEstimate::point_speed_sigma() const {
  return std::sqrt(std::max(0.0, covariance.trace() + (inertia * angular_covariance).trace()));
}

DOT_INLINE MotionEstimate MotionEstimate::rotated(const Matrix3<double>& R) const {
  MotionEstimate out = *this;
  out.velocity = R * velocity;
  out.angular_velocity = R * angular_velocity;
  out.covariance = R * covariance * R.transpose();
  out.depth_covariance = R * depth_covariance * R.transpose();
  out.angular_covariance = R * angular_covariance * R.transpose();
  out.inertia = R * inertia * R.transpose();
  return out;
}

DOT_INLINE Matrix3<double> inertia_of(const PointSet& points, const Vector3<double>& centroid) {
  constexpr std::size_t kEnough = 128;                // points
  Matrix3<double> squares = Matrix3<double>::Zero();  // mean of r r'
  int n = 0;
  const std::size_t size = points.u.size();
  for (std::size_t i = 0; i < size; i += (size + kEnough - 1) / kEnough) {
    if (!(points.q[i] > 0)) continue;
    const double z = 1 / static_cast<double>(points.q[i]);
    const Vector3<double> r = Vector3<double>(points.x[i] * z, points.y[i] * z, z) - centroid;
    squares += r * r.transpose();
    ++n;
  }
  if (n > 0) squares /= n;
  return squares.trace() * Matrix3<double>::Identity() - squares;
}

DOT_END_NAMESPACE
