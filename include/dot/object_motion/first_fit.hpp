// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "dot/object_motion/fit.hpp"
#include "dot/object_motion/settings.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// How far a fit is trusted that no known velocity leads, as an object's first. It may end in a wrong minimum. A wrong
/// one correlates worse than most right ones, and the fit in the other direction hardly ever ends in the same one.
struct FirstFit {
  static constexpr double kSurePhi = 0.95;  ///< Pearson correlation from which on nothing speaks against a fit
  static constexpr double kMostTurn = 3;    ///< sigmas of the prior's rotation and of the fit's, seldom exceeded

  /// Whether nothing speaks against it.
  static bool is_sure(const ObjectFit& fit) { return fit.phi >= kSurePhi; }

  /// Whether it may be wrong: it is not sure, and a better minimum failed the checks, or it turns faster than things
  /// mostly do. @param is_best no other minimum was ranked before it.
  static bool is_doubtful(const ObjectFit& fit, bool is_best, const MotionPriorSettings& prior) {
    // |w|^2 > k^2 (sigma^2 + w' W w / |w|^2)
    const Vector3<double>& w = fit.motion.angular_velocity;
    const double w2 = w.squaredNorm(),
                 variance = prior.rotation * prior.rotation * w2 + w.dot(fit.motion.angular_covariance * w);
    const bool turns = w2 * w2 > kMostTurn * kMostTurn * variance;
    return !is_sure(fit) && (!is_best || turns);
  }

  /// Whether two motions in the same axes agree within three sigma.
  static bool agree(const MotionEstimate& a, const MotionEstimate& b) {
    const Vector3<double> d = a.velocity - b.velocity;
    return d.dot((a.covariance + b.covariance).ldlt().solve(d)) <= chi2::k3SigmaOf3;
  }
};

DOT_END_NAMESPACE
