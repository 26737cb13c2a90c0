// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "dot/pipeline/result.hpp"

namespace runner {

/// What turning adds to the speed of an object's points, m/s: root of the mean square over the points.
struct Turning {
  double speed = 0;
  double sigma = 0;  ///< 0: it was not measured

  /// Faster than `limit` beyond doubt, by two sigma.
  bool exceeds(double limit) const { return speed - 2 * sigma > limit; }
};

/// From `point_speed`, which holds both, and `speed`, which is that of the centroid. Valid if the object was measured.
Turning turning_of(const dot::ObjectResult& object);

/// Whether turning moves the points faster than the centroid moves. Then `point_speed` is the speed to show.
bool mostly_turns(const dot::ObjectResult& object);

/// The speed of a measured object that moves, for a label: "8.1 m/s", "0.041 m/s".
std::string speed_label(const dot::ObjectResult& object);

}  // namespace runner
