// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/motion/settings.hpp"
#include "dot/object_motion/fit.hpp"
#include "dot/object_motion/problem.hpp"

DOT_BEGIN_NAMESPACE

/// Variance per axis of what the velocity over the last `dt` may differ from that over the whole `span` before: it
/// may have changed since the middle of it, of traffic mostly by a third of `acceleration`, m/s^2.
inline double variance_of_change(double span, double dt, double acceleration) {
  constexpr double kMostly = 0.3;  // share of the acceleration
  const double changed = 0.5 * (kMostly * acceleration) * (span - dt);
  return changed * changed;
}

/// The share of the last frame interval, at constant velocity, of a fit to an older reference, in the axes of the
/// previous camera.
/// @param T_prev_ref camera motion from the reference to the previous frame; @param dt seconds since that frame.
/// @param acceleration m/s^2.
DOT_INLINE ObjectFit over_last_interval(const ObjectFit& fit, const SE3d& T_prev_ref, double dt, double acceleration);

/// A motion that turns, about a point, no further than its fit is sure of. The fit weighs `motion_prior.rotation`
/// against residuals that it takes for independent; with the covariance S that they really give and the prior P, the
/// mean of both turns by P (P + S)^-1 w. Outlines need it: turned to and fro by the noise, the far ones fray.
/// @param T_o in the axes of the fit. @param centre the point, before it moves. @param dt seconds.
DOT_INLINE SE3d shrink_rotation(const SE3d& T_o, const ObjectFit& fit, const Vector3<double>& centre, double dt,
                                double photometric_scale, const MotionPriorSettings& prior);

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/last_interval.hpp"
#endif
