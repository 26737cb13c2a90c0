// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "dot/statistics/chi2.hpp"

/// @file
/// Definitions of object_motion/first_fit.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

DOT_INLINE bool FirstFit::is_doubtful(const ObjectFit& first, const std::optional<ObjectFit>& backwards,
                                      const MotionPriorSettings& prior) {
  const bool turns = first.motion.angular_velocity.norm() > kMostTurn * prior.rotation;
  if (is_sure(first) || (first.is_lowest && !turns)) return false;
  if (!backwards) return true;
  const Vector3<double> d = first.motion.velocity - backwards->motion.velocity;
  return d.dot((first.motion.covariance + backwards->motion.covariance).ldlt().solve(d)) > chi2::k3SigmaOf3;
}

DOT_END_NAMESPACE
