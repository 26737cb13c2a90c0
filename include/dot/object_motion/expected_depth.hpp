// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Where along the optical axis an object can be, by the newest frame in which it was measured.
struct ExpectedDepth {
  double metres = 0;     ///< 0: not known
  double tolerance = 0;  ///< metres: the object's own motion since then, its size and the error of its depth

  /// Whether the object cannot be at a depth in metres; 0: not measured.
  bool excludes(double depth) const { return metres > 0 && depth > 0 && std::abs(depth - metres) > tolerance; }
};

DOT_END_NAMESPACE
