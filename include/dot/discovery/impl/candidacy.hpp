// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <Eigen/Cholesky>

/// @file
/// Definitions of discovery/candidacy.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE void Candidacy::confirm(const ObjectStep& step, const ObjectBelief& belief, const VelocitySettings& settings,
                                   double dt) {
  const Reason reason = step.fit.reason;
  if (reason == Reason::Occluded || reason == Reason::LeavesImage || reason == Reason::Hidden) return;
  tried += dt;
  bool agrees = step.fit.ok();
  if (agrees) {
    if (!belief.has_velocity()) return;  // the first fit
    const MotionEstimate& m = step.fit.motion;
    const Vector3<double> d = m.velocity - belief.velocity_now;
    agrees = d.dot((m.covariance + belief.velocity_covariance).ldlt().solve(d)) < chi2::k99Of3;
    SingleFrameClassifier::Memory none;
    agrees =
        agrees && step.has_evidence &&
        SingleFrameClassifier{settings}(none, &step.evidence, Matrix3<double>::Identity(), dt).state == State::Moving;
  }
  confirmed = std::clamp(confirmed + (agrees ? 1 : -1) * dt, 0.0, kMaxConfirmedSeconds);
  if (was_confirmed()) tried = 0;
}

DOT_END_NAMESPACE
