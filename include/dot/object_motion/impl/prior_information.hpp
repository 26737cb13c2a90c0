// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/LU>

/// @file
/// Definitions of object_motion/problem.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE Matrix6<double> prior_information(const MotionPriorSettings& prior, double dt) {
  Matrix6<double> P = Matrix6<double>::Zero();
  const double t = 1 / std::pow(prior.velocity * dt, 2), r = 1 / std::pow(prior.rotation * dt, 2);
  P.diagonal() << t, t, t, r, r, r;
  if (prior.ground_vehicle) {
    constexpr double kStiffness = 99;  // vertical, pitch and roll: a tenth of the other sigmas, hence 10^2 - 1
    const Vector3<double> up = Vector3<double>(prior.up_x, prior.up_y, prior.up_z).normalized();
    const Matrix3<double> vertical = up * up.transpose();
    P.topLeftCorner<3, 3>() += kStiffness * t * vertical;
    P.bottomRightCorner<3, 3>() += kStiffness * r * (Matrix3<double>::Identity() - vertical);
  }
  return P;
}

DOT_INLINE Matrix3<double> without_prior(const Matrix3<double>& S, const MotionPriorSettings& prior, double dt) {
  constexpr double kTakenOut = 0.9;
  const Matrix3<double> P = prior_information(prior, dt).bottomRightCorner<3, 3>();
  return (Matrix3<double>::Identity() - kTakenOut * S * P).inverse();
}

DOT_END_NAMESPACE
