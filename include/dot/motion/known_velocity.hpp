// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/motion/estimate.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Velocity that an object had a moment ago. Fits are compared with it, because accelerations are limited.
struct KnownVelocity {
  Vector3<double> velocity = Vector3<double>::Zero();    ///< m/s
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< (m/s)^2
  double seconds = 0;                                    ///< since then; 0: nothing is known

  /// Whether a fit in the same axes differs by more than errors and an acceleration, m/s^2, explain. Such a fit has
  /// locked onto something else, mostly onto the background of a moving object. Errors and acceleration are limited to
  /// three sigma, 99.7 %, of a normal: d' (V + V_known + (a t)^2 / k I)^-1 d <= k, where k is that quantile of chi^2 of
  /// three degrees.
  bool contradicts(const MotionEstimate& fit, double max_acceleration) const;

  /// The correction of a fit's velocity, in the same axes, that gives the mean of both velocities weighted by their
  /// covariances V and P. It is the Kalman update V (V + P)^-1 (v - v_fit), m/s.
  Vector3<double> correction(const MotionEstimate& fit) const;
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/known_velocity.hpp"
#endif
