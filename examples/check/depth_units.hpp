// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

namespace check {

/// A unit that is in use for depth images.
struct DepthUnit {
  double per_metre;
  const char* name;
};

constexpr std::array<DepthUnit, 4> depth_units{
    {{100, "centimetres"}, {256, "1/256 m"}, {1000, "millimetres"}, {5000, "1/5000 m"}}};

/// Depths of this unit, read as if `stated` values made a metre, over the true ones.
inline double too_far(const DepthUnit& unit, double stated) { return unit.per_metre / stated; }

inline const DepthUnit& nearest_unit(double ratio, double stated) {
  const DepthUnit* nearest = &depth_units[0];
  const auto distance = [&](const DepthUnit& unit) { return std::abs(std::log(ratio / too_far(unit, stated))); };
  for (const DepthUnit& unit : depth_units)
    if (distance(unit) < distance(*nearest)) nearest = &unit;
  return *nearest;
}

}  // namespace check
