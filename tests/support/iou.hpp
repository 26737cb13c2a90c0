// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/mask/mask.hpp"

namespace dot::test {

/// Intersection over union of two masks; 0 if both are empty.
inline double iou(const Mask& a, const Mask& b) {
  const int both = overlap(a, b);
  return both > 0 ? static_cast<double>(both) / (a.area + b.area - both) : 0;
}

}  // namespace dot::test
