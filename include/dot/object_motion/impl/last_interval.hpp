// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>

/// @file
/// Definitions of object_motion/last_interval.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE ObjectFit over_last_interval(const ObjectFit& fit, const SE3d& T_prev_ref, double dt, double acceleration) {
  const double span = fit.motion.span_seconds, share = dt / span;
  if (share > 1 - 1e-6) return fit;
  ObjectFit out = fit;
  out.T_o = T_prev_ref * SE3d::exp(share * fit.T_o.log()) * T_prev_ref.inverse();
  const Matrix3<double>& R = T_prev_ref.R;
  Matrix6<double> turn = Matrix6<double>::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = share * R;
  out.sigma = turn * fit.sigma * turn.transpose();
  out.motion = fit.motion.rotated(R);
  out.motion.covariance.diagonal().array() += variance_of_change(span, dt, acceleration);
  return out;
}

DOT_INLINE SE3d shrink_rotation(const SE3d& T_o, const ObjectFit& fit, const Vector3<double>& centre, double dt,
                                double photometric_scale, const MotionPriorSettings& prior) {
  const Matrix3<double> S = photometric_scale * fit.sigma.bottomRightCorner<3, 3>();
  const Matrix3<double> P = prior_information(prior, dt).bottomRightCorner<3, 3>().inverse();
  const Matrix3<double> R = so3::exp(P * (P + S).ldlt().solve(so3::log(T_o.R)));
  return {R, T_o * centre - R * centre};
}

DOT_END_NAMESPACE
