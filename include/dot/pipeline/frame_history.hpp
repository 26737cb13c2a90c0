// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/pipeline/recycling_list.hpp"

DOT_BEGIN_NAMESPACE

/// Past frames, oldest first. The memory of those that were dropped serves the next ones.
/// @tparam Past has `timestamp()`, seconds.
template <typename Past>
class FrameHistory {
 public:
  /// The newest frame, with the contents of a dropped one or of a new Past: to be filled in by the caller.
  Past& add() { return frames_.push_back(); }

  /// Drops the frames before this time, seconds.
  void drop_before(double timestamp) {
    while (!frames_.empty() && frames_.front().timestamp() < timestamp) frames_.pop_front();
  }
  void clear() { frames_.clear(); }

  auto begin() { return frames_.begin(); }
  auto end() { return frames_.end(); }
  bool empty() const { return frames_.empty(); }

 private:
  RecyclingList<Past> frames_;
};

DOT_END_NAMESPACE
