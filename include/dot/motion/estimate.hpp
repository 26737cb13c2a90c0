// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/lie/se3.hpp"
#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// An object's motion over one interval, as estimated by its fit. It is the input of every classifier. Axes: the camera
/// of the reference, which is the frame at the start of the interval.
///
/// A rigid motion moves each point of the object differently. A point at r from the centroid has the velocity v + w x
/// r. The mean of the square over all points is |v|^2 + w' J w, where J is the mean of |r|^2 I - r r'.
struct MotionEstimate {
  Vector3<double> velocity = Vector3<double>::Zero();          ///< v, of the centroid, m/s
  Vector3<double> angular_velocity = Vector3<double>::Zero();  ///< w, rad/s
  Matrix3<double> covariance = Matrix3<double>::Zero();        ///< of v: photometric, camera's and depth's share
  Matrix3<double> depth_covariance = Matrix3<double>::Zero();  ///< the part from the depth errors that the points share
  Matrix3<double> angular_covariance = Matrix3<double>::Zero();  ///< of w, likewise
  Matrix3<double> inertia = Matrix3<double>::Zero();  ///< J, m^2, of the points about the centroid; zero: not known
  double span_seconds = 0;                            ///< seconds the fit spans
  double span_frames = 1;                             ///< frames the fit spans
  double range = 0;                                   ///< depth of the centroid, metres
  double disparity_px = 0;                            ///< d_d, see motion/disparity.hpp
  double disparity_noise_px = 0;                      ///< its noise due to Sigma_x alone
  double entropy = 0;                                 ///< H of Sigma_x, nats
  bool is_doubtful = false;  ///< may be of a wrong minimum, see FirstFit: alone it should not decide *moving*

  /// Speed of the points, m/s: root of the mean square over all of them.
  double point_speed() const;
  /// Standard deviation of the points' velocities, m/s: root of the mean over all points of the trace of their
  /// covariance.
  double point_speed_sigma() const;

  /// The same motion in other axes.
  MotionEstimate rotated(const Matrix3<double>& R) const;
};

/// MotionEstimate::inertia of points, from at most 128 of them.
DOT_INLINE Matrix3<double> inertia_of(const PointSet& points, const Vector3<double>& centroid);

/// Differential entropy of a 6-dof Gaussian, H = 1/2 ln((2 pi e)^6 |Sigma|), nats (paper eq. 7). It is *high* if the
/// motion is badly determined.
DOT_INLINE double entropy(const Matrix6<double>& sigma);

/// Covariance of the twist of T_o about the moved centroid, due to the camera covariance. T_c T_o moves the centroid to
/// X (camera axes of the new frame). So an error xi of T_c displaces it by -R_c' [I | -[X]x] xi and turns the object by
/// -R_c' [0 | I] xi.
DOT_INLINE Matrix6<double> camera_share(const Matrix6<double>& camera_covariance, const SE3d& T_c,
                                        const Vector3<double>& X);

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/estimate.hpp"
#endif
