// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "latency.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
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
  double seen = 0, speed = 0;  ///< time and speed of the last sighting whose speed is known
  double metres = 0;           ///< since the event
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
        watch.metres = 0;
        if (sighting.frame >= from && sighting.range < max_range && sighting.area >= min_area) {
          watch.open = events.size();
          watch.since = sighting.time;
          events.push_back({sighting.id, sighting.frame, fast, std::nullopt});
        }
      }
      watch.moves = fast;
    }
    if (watch.open && sighting.time > watch.since)
      watch.metres += 0.5 * (watch.speed + sighting.speed) * (sighting.time - watch.seen);
    watch.seen = sighting.time;
    watch.speed = sighting.speed;
    if (!watch.open) continue;
    LatencyEvent& event = events[*watch.open];
    if (sighting.answer != (event.starts ? Answer::Moving : Answer::Static)) continue;
    event.seconds = sighting.time - watch.since;
    event.metres = watch.metres;
    watch.open.reset();
  }
  return events;
}

std::vector<LatencyEvent> events_of(const std::vector<LatencyEvent>& events, bool starts) {
  std::vector<LatencyEvent> some;
  std::copy_if(events.begin(), events.end(), std::back_inserter(some),
               [&](const LatencyEvent& event) { return event.starts == starts; });
  return some;
}

double latency(const std::vector<LatencyEvent>& events, double q) {
  std::vector<double> seconds;
  seconds.reserve(events.size());
  for (const LatencyEvent& event : events)
    seconds.push_back(event.seconds.value_or(std::numeric_limits<double>::infinity()));
  return percentile(std::move(seconds), q);
}

double displacement(const std::vector<LatencyEvent>& events, double q) {
  std::vector<double> metres;
  metres.reserve(events.size());
  for (const LatencyEvent& event : events)
    metres.push_back(event.seconds ? event.metres : std::numeric_limits<double>::infinity());
  return percentile(std::move(metres), q);
}

}  // namespace eval
