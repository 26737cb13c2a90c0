// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

namespace check {

/// A unit that is in use for depth images, where 1/256 m is expected.
struct DepthUnit {
  double too_far;  ///< depths read as 1/256 m over the true ones
  const char* name;
};

constexpr std::array<DepthUnit, 3> depth_units{
    {{100 / 256.0, "centimetres"}, {1000 / 256.0, "millimetres"}, {5000 / 256.0, "1/5000 m"}}};

inline const DepthUnit& nearest_unit(double too_far) {
  const DepthUnit* nearest = &depth_units[0];
  for (const DepthUnit& unit : depth_units)
    if (std::abs(std::log(too_far / unit.too_far)) < std::abs(std::log(too_far / nearest->too_far))) nearest = &unit;
  return *nearest;
}

}  // namespace check
