// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Where something is, metres, if that is known.
struct Place {
  Vector3<double> at = Vector3<double>::Zero();
  bool known = false;

  /// The same in other axes, or after a motion; what is not known stays so.
  Place moved(const SE3d& T) const { return known ? Place{T * at, true} : Place{}; }

  /// Whether it is known to be before the camera in whose axes it is.
  bool is_ahead() const { return known && at.z() > 0; }
  double inverse_depth() const { return is_ahead() ? 1 / at.z() : 0.0; }
};

DOT_END_NAMESPACE
