// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/motion/settings.hpp"
#include "dot/object_motion/fit.hpp"
#include "dot/object_motion/problem.hpp"
#include "dot/object_motion/settings.hpp"

DOT_BEGIN_NAMESPACE

/// Variance per axis of the difference between the velocity over the last `dt` and that over the whole `span`. The
/// velocity may have changed since the middle of the span, by the usual share of `acceleration`, m/s^2.
inline double variance_of_change(double span, double dt, double acceleration) {
  const double changed = 0.5 * (VelocitySettings::kUsualShare * acceleration) * (span - dt);
  return changed * changed;
}

/// Reduces a fit to an older reference to its share of the last frame interval, at constant velocity. The result is in
/// the axes of the previous camera.
/// @param T_prev_ref camera motion from the reference to the previous frame; @param dt seconds since that frame.
/// @param acceleration m/s^2.
DOT_INLINE ObjectFit over_last_interval(const ObjectFit& fit, const SE3d& T_prev_ref, double dt, double acceleration);

/// Shrinks the rotation of a motion, about a point, to what its fit is certain of. The fit weighs
/// `motion_prior.rotation` against residuals that it assumes to be independent. They are
/// correlated, so the covariance S of the rotation w is larger. With S and the prior P, the mean of prior and fit turns
/// by P (P + S)^-1 w. Noise of the rotation would distort far outlines.
/// @param T_o in the axes of the fit. @param centre the point, before it moves. @param dt seconds.
DOT_INLINE SE3d shrink_rotation(const SE3d& T_o, const ObjectFit& fit, const Vector3<double>& centre, double dt,
                                double photometric_scale, const MotionPriorSettings& prior);

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/object_motion/impl/last_interval.hpp"
#endif
