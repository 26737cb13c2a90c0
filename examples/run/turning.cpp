// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "turning.hpp"

#include <algorithm>
#include <cmath>

#include "sequence/text.hpp"

namespace runner {

Turning turning_of(const dot::ObjectResult& object) {
  const auto& V = object.velocity_covariance;
  const double square = object.point_speed * object.point_speed - object.speed * object.speed;
  const double variance = object.point_speed_sigma * object.point_speed_sigma - (V[0] + V[4] + V[8]);
  return {std::sqrt(std::max(0.0, square)), std::sqrt(std::max(0.0, variance))};
}

bool mostly_turns(const dot::ObjectResult& object) { return turning_of(object).exceeds(object.speed); }

std::string speed_label(const dot::ObjectResult& object) {
  const double speed = mostly_turns(object) ? object.point_speed : object.speed;
  return format(speed < 0.1 ? "%.3f m/s" : "%.1f m/s", speed);
}

}  // namespace runner
