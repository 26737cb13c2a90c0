// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

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

DOT_INLINE Matrix3<double> camera_share(const Matrix6<double>& camera_covariance, const SE3d& T_c,
                                        const Vector3<double>& X) {
  Eigen::Matrix<double, 3, 6> A;
  A << Matrix3<double>::Identity(), -so3::hat(X);
  A = T_c.R.transpose() * A;
  return A * camera_covariance * A.transpose();
}

DOT_END_NAMESPACE
