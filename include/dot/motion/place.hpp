// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// A position, metres, if it is known.
struct Place {
  Vector3<double> at = Vector3<double>::Zero();  ///< metres
  bool known = false;                            ///< whether `at` means something

  /// The position in other axes, or after a motion. An unknown position stays unknown.
  Place moved(const SE3d& T) const { return known ? Place{T * at, true} : Place{}; }

  /// Whether it is known to be in front of the camera in whose axes it is given.
  bool is_ahead() const { return known && at.z() > 0; }
  /// 1/m; 0 if it is not known to be ahead.
  double inverse_depth() const { return is_ahead() ? 1 / at.z() : 0.0; }
};

DOT_END_NAMESPACE
