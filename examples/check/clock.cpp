// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "measures.hpp"
#include "median.hpp"
#include "words.hpp"

/// @file
/// The timestamps: whether they are seconds, increase, and leave gaps. All frames of the recording are looked at.

namespace check {
namespace {

std::vector<double> steps(const std::vector<runner::RecordingEntry>& entries) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < entries.size(); ++i) steps.push_back(entries[i].timestamp - entries[i - 1].timestamp);
  return steps;
}

struct Unit {
  double per_second;
  const char* name;
};

/// The unit in which the step would be one of a camera that takes 0.5 to 1000 pictures a second.
Unit likely_unit(double step) {
  if (step < 2e3) return {1e3, "milliseconds"};
  if (step < 2e6) return {1e6, "microseconds"};
  return {1e9, "nanoseconds"};
}

Finding unit_finding(double step) {
  constexpr double longest = 2, shortest = 5e-4;  // seconds from frame to frame
  const std::string said = number(step, step < 1 ? 6 : 1) + " s from frame to frame by the timestamps";
  if (step > longest) {
    const Unit unit = likely_unit(step);
    return faulty(
        "time-unit", unit.per_second, "per second",
        said + ": they look like " + unit.name + ", " + number(unit.per_second / step, 1) + " frames a second.",
        "Give the times in seconds: divide them by " + number(unit.per_second, 0) +
            ". As they are, every frame counts as the first after a gap, and nothing is tracked.");
  }
  if (step < shortest)
    return faulty("time-unit", step, "s", said + ": too short for a camera.",
                  "Give the times in seconds. As they are, speeds are far too high.");
  return fine("time-unit", step, "s", said + ".");
}

Finding order_finding(const std::vector<double>& steps) {
  const auto backwards = static_cast<int>(std::count_if(steps.begin(), steps.end(), [](double s) { return s <= 0; }));
  if (backwards == 0) return fine("time-order", 0, "frames", "The timestamps increase.");
  return faulty("time-order", backwards, "frames",
                count_text(backwards, "frame") + " of " + text(static_cast<int>(steps.size()) + 1) +
                    " not later than the one before.",
                "Sort the frames by the time at which they were taken, and leave out those that come twice.");
}

/// Gaps of an otherwise regular clock.
Finding gap_finding(const std::vector<double>& steps, double usual) {
  constexpr double gap = 1.6, regular = 0.2;  // of the usual step
  std::vector<double> deviations;
  deviations.reserve(steps.size());
  for (const double step : steps) deviations.push_back(std::abs(step - usual));
  if (!(usual > 0) || median(deviations) > regular * usual)
    return unknown("frames-dropped", "The frames come at irregular times.");
  constexpr double most = 1e6;  // frames: more is no gap but another clock
  int missing = 0, places = 0;
  for (const double step : steps)
    if (step > gap * usual) ++places, missing += static_cast<int>(std::min(most, std::round(step / usual))) - 1;
  if (missing == 0) return fine("frames-dropped", 0, "frames", "The timestamps leave no gaps.");
  return faulty(
      "frames-dropped", missing, "frames",
      count_text(missing, "frame") + " missing in " + count_text(places, "gap") + " of the timestamps.",
      "Look for a full disk, a slow writer or a queue that drops. A gap of over a second makes the tracker start "
      "anew; in a shorter one fast things may be lost.");
}

}  // namespace

Findings check_clock(const Samples& samples) {
  const std::vector<double> all = steps(samples.recording.entries);
  if (all.empty()) {
    const char* const why = "There is one frame only.";
    return {unknown("time-unit", why), unknown("time-order", why), unknown("frames-dropped", why)};
  }
  const double usual = median(all);
  return {unit_finding(usual), order_finding(all), gap_finding(all, usual)};
}

}  // namespace check
