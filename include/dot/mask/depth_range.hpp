// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/abi.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Inverse depths that one object can have.
struct DepthRange {
  float far;   ///< 1/m, the smallest
  float near;  ///< 1/m, the largest

  /// Whether a measured inverse depth can be the object's.
  bool holds(float q) const { return q >= far && q <= near; }
};

/// The range of an object of which most pixels have the inverse depths of `most`.
/// @param extent metres that it can reach beyond them, towards the camera and away. @param slack 1/m, of the noise.
inline DepthRange depth_range(const Spread<float>& most, float extent, float slack) {
  constexpr float kNearest = 1e6f;  // 1/m: no bound
  const float z_near = 1 / most.high - extent;
  return {1 / (1 / most.low + extent) - slack, (z_near > 0 ? 1 / z_near : kNearest) + slack};
}

/// Depth of most of an object's pixels, from the nearest to the farthest, metres.
inline float depth_of(const Spread<float>& most) { return 1 / most.low - 1 / most.high; }

/// Metres that an object with these inverse depths can usually reach beyond them: more for a farther one, and for one
/// that is deep itself, but not more than a car is long.
inline float usual_extent(const Spread<float>& most) {
  const float extent = 0.25f / most.middle + depth_of(most);
  return extent < 3.5f ? extent : 3.5f;
}

DOT_END_NAMESPACE
