// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "latency.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>

namespace eval {
namespace {

constexpr double max_range = 30;  // metres
constexpr long min_area = 1000;   // pixels

/// One object as it is followed through the sequence.
struct Watch {
  std::optional<bool> moves;        ///< what it last did beyond doubt
  std::optional<std::size_t> open;  ///< event that waits for its answer
  double since = 0;
};

}  // namespace

std::vector<LatencyEvent> decision_latency(const std::vector<Sighting>& sightings, double v0, int from) {
  std::vector<LatencyEvent> events;
  std::map<int, Watch> watches;
  for (const Sighting& sighting : sightings) {
    if (sighting.speed < 0) continue;
    Watch& watch = watches[sighting.id];
    const bool fast = sighting.speed >= 2 * v0;
    const bool slow = sighting.speed < v0 / 2;
    if (fast || slow) {
      if (watch.moves && *watch.moves != fast) {
        watch.open.reset();
        if (sighting.frame >= from && sighting.range < max_range && sighting.area >= min_area) {
          watch.open = events.size();
          watch.since = sighting.time;
          events.push_back({sighting.id, sighting.frame, fast, std::nullopt});
        }
      }
      watch.moves = fast;
    }
    if (!watch.open) continue;
    LatencyEvent& event = events[*watch.open];
    if (sighting.answer != (event.starts ? Answer::Moving : Answer::Static)) continue;
    event.seconds = sighting.time - watch.since;
    watch.open.reset();
  }
  return events;
}

double median_latency(const std::vector<LatencyEvent>& events) {
  std::vector<double> seconds;
  seconds.reserve(events.size());
  for (const LatencyEvent& event : events)
    seconds.push_back(event.seconds.value_or(std::numeric_limits<double>::infinity()));
  return median(std::move(seconds));
}

}  // namespace eval
