// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <Eigen/Cholesky>

#include "dot/lie/so3.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Motion of something that may be a part of a body. All in the axes of one camera.
struct PartMotion {
  Vector3<double> at = Vector3<double>::Zero();                  ///< metres
  double size = 0;                                               ///< metres
  Vector3<double> velocity = Vector3<double>::Zero();            ///< m/s
  Matrix3<double> covariance = Matrix3<double>::Zero();          ///< of the velocity, (m/s)^2
  Vector3<double> angular_velocity = Vector3<double>::Zero();    ///< rad/s
  Matrix3<double> angular_covariance = Matrix3<double>::Zero();  ///< of it, (rad/s)^2
};

/// The two motions that `move_apart` tries.
namespace moving_apart {

/// Whether a difference is within five sigma. @param d m/s. @param S its covariance, (m/s)^2.
inline bool explains(const Vector3<double>& d, const Matrix3<double>& S) {
  return !(d.dot(S.ldlt().solve(d)) > chi2::k5SigmaOf1);
}

/// Whether the rotation of `a` makes one body of both. The body is not longer than what is seen of it, and does not
/// turn faster than three sigma.
inline bool are_one_body(const PartMotion& a, const PartMotion& b) {
  constexpr double kThreeOfFive = 0.36;  // squared
  const double together = a.size + b.size;
  Vector3<double> r = b.at - a.at;
  r *= std::min(1.0, together / std::max(together, r.norm()));
  const Matrix3<double> R = so3::hat(r);
  return explains(b.velocity - a.velocity - a.angular_velocity.cross(r),
                  a.covariance + b.covariance + kThreeOfFive * R * a.angular_covariance * R.transpose());
}

/// Whether `b` moves as `a` would at its depth. @param c velocity of the camera. As far as the body is deep, the ratio
/// of the depths is not known.
inline bool seems_at_other_depth(const PartMotion& a, const PartMotion& b, const Vector3<double>& c) {
  const double k = b.at.z() / a.at.z(), deep = a.size / a.at.z() + b.size / b.at.z();
  const Vector3<double> relative = a.velocity - c;
  const double turns = a.angular_velocity.squaredNorm() + a.angular_covariance.trace() / 3;
  const Matrix3<double> of_depth = deep * deep * relative * relative.transpose();
  const Matrix3<double> of_place = a.size * a.size * turns * Matrix3<double>::Identity();
  return explains(b.velocity - c - k * relative, b.covariance + k * k * (a.covariance + of_depth + of_place));
}

}  // namespace moving_apart

/// Whether two parts of a mask are of two bodies. They are not if one of two motions explains both, within five sigma.
///
/// One rigid body: v_b = v_a + w x r, with r from a to b.
///
/// One body whose depth is wrong in one part. A thing that seems k = z_b / z_a times as far seems to move k times as
/// fast relative to the camera, because the images are the same: v_b - c = k (v_a - c).
/// @param camera_velocity c, m/s.
inline bool move_apart(const PartMotion& a, const PartMotion& b, const Vector3<double>& camera_velocity) {
  if (!(a.at.z() > 0 && b.at.z() > 0)) return false;
  // The rotation of the part that is known better is that of the body.
  const bool first = a.angular_covariance.trace() < b.angular_covariance.trace();
  if (moving_apart::are_one_body(first ? a : b, first ? b : a)) return false;
  return !moving_apart::seems_at_other_depth(a, b, camera_velocity) ||
         !moving_apart::seems_at_other_depth(b, a, camera_velocity);
}

DOT_END_NAMESPACE
