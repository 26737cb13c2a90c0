// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "object_score.hpp"

namespace eval {

/// An object that starts to move, or stops, and how long it took to be told so.
struct LatencyEvent {
  int id = 0;
  int frame = 0;
  bool starts = false;
  std::optional<double> seconds;  ///< until the first right answer; none: never given while it lasted
  double metres = 0;              ///< that it went in this time, by its true speeds
};

/// Events of near (under 30 m) and large (1,000 pixels or more) objects. An object starts in the first frame at 2 v0 or
/// more after it stood (under v0 / 2), and stops in the first frame under v0 / 2 after it moved (2 v0 or more). The
/// wait ends at the first answer *moving* or *static*, respectively; without one, when the object does the opposite or
/// is seen no more.
/// @param sightings in order of time.
/// @param v0 m/s.
/// @param from events in frames with a smaller number do not count.
std::vector<LatencyEvent> decision_latency(const std::vector<Sighting>& sightings, double v0, int from = 0);

/// The starts alone, or the stops.
std::vector<LatencyEvent> events_of(const std::vector<LatencyEvent>& events, bool starts);

/// Percentile q of the seconds, or of the metres; events without an answer count as infinitely long and far.
double latency(const std::vector<LatencyEvent>& events, double q);
double displacement(const std::vector<LatencyEvent>& events, double q);

}  // namespace eval
