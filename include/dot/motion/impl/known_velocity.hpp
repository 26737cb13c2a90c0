// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

/// @file
/// Definitions of motion/known_velocity.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE bool KnownVelocity::contradicts(const MotionEstimate& fit, double max_acceleration) const {
  if (!(seconds > 0)) return false;
  constexpr double k = chi2::k3SigmaOf3;
  const double change = max_acceleration * seconds;
  const Matrix3<double> S = fit.covariance + covariance + Matrix3<double>::Identity() * (change * change / k);
  const Vector3<double> d = fit.velocity - velocity;
  return d.dot(S.ldlt().solve(d)) > k;
}

DOT_INLINE Vector3<double> KnownVelocity::correction(const MotionEstimate& fit) const {
  return fit.covariance * (fit.covariance + covariance).ldlt().solve(velocity - fit.velocity);
}

DOT_END_NAMESPACE
