// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>

#include "dot/pipeline/result.hpp"
#include "object_score.hpp"
#include "sequence/sequence.hpp"
#include "statistics.hpp"

namespace eval {

/// How much of movers that no mask shows is found, and what is found wrongly.
struct HiddenScore {
  int movers = 0;
  long pixels = 0;       ///< of hidden movers, where they count
  long found = 0;        ///< of these labelled moving
  long standing = 0;     ///< pixels that do not move
  long false_alarm = 0;  ///< of these labelled moving
  long moving = 0;       ///< all pixels labelled moving

  double found_share() const { return ratio(static_cast<double>(found), static_cast<double>(pixels)); }
  double false_share() const { return ratio(static_cast<double>(false_alarm), static_cast<double>(standing)); }
  double outside_share() const { return ratio(static_cast<double>(false_alarm), static_cast<double>(moving)); }
  void add(const HiddenScore& other);
};

/// Removes from the masks of a frame the instances of which at least half lies in one of these true objects.
void remove_movers(const std::set<int>& movers, const cv::Mat& instance, runner::SequenceFrame& frame);

/// Takes every second true mover (by id: the 2nd, 4th, ...) out of the masks that the tracker gets, and measures how
/// much of it is labelled moving all the same. In a recording without masks all movers count as taken out.
class HiddenMovers {
 public:
  HiddenMovers(const runner::Recording& recording, const ObjectScoring& scoring);

  void remove(runner::SequenceFrame& frame, const cv::Mat& instance) const { remove_movers(hidden_, instance, frame); }

  /// A mover counts from the sixth frame in which it has 1,000 pixels and the speed, in frames where it has both.
  /// Frames before ObjectScoring::from only count as such.
  void add(const runner::RecordingEntry& entry, const cv::Mat& instance, const dot::Result& result);

  const HiddenScore& score() const { return score_; }

 private:
  ObjectScoring scoring_;
  std::set<int> hidden_;
  std::map<int, int> seen_;  ///< of each hidden mover: frames in which it was large and fast
  HiddenScore score_;
};

}  // namespace eval
