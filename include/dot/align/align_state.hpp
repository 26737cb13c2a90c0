// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/lie/se3.hpp"

DOT_BEGIN_NAMESPACE

/// Pose and photometric parameters at which a reduction linearises.
struct AlignState {
  SE3d T;             ///< T_i_j of the points
  double gain = 1;    ///< a
  double offset = 0;  ///< b, grey values

  /// The same exposure at another pose.
  AlignState at(const SE3d& other) const { return {other, gain, offset}; }
};

DOT_END_NAMESPACE
