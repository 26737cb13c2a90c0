// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// An object's motion over one interval, as estimated by its fit. It is the input of every classifier. Axes: the camera
/// of the reference, which is the frame at the start of the interval.
struct MotionEstimate {
  Vector3<double> velocity = Vector3<double>::Zero();    ///< of the centroid, m/s
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< of the velocity: photometric, camera's and depth's share
  double span_seconds = 0;                               ///< seconds the fit spans
  double span_frames = 1;                                ///< frames the fit spans
  double range = 0;                                      ///< depth of the centroid, metres
  double disparity_px = 0;                               ///< d_d, see motion/disparity.hpp
  double disparity_noise_px = 0;                         ///< its noise due to Sigma_x alone
  double entropy = 0;                                    ///< H of Sigma_x, nats
};

/// Differential entropy of a 6-dof Gaussian, H = 1/2 ln((2 pi e)^6 |Sigma|), nats (paper eq. 7). It is *high* if the
/// motion is badly determined.
DOT_INLINE double entropy(const Matrix6<double>& sigma);

/// Covariance of the centroid's displacement due to the camera covariance. T_c T_o moves the centroid to X (camera axes
/// of the new frame). So an error xi of T_c displaces it by -A xi, A = R_c' [I | -[X]x].
DOT_INLINE Matrix3<double> camera_share(const Matrix6<double>& camera_covariance, const SE3d& T_c,
                                        const Vector3<double>& X);

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/estimate.hpp"
#endif
