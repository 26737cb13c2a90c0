// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Past frames, oldest first. The memory of those that were dropped serves the next ones.
/// @tparam Past has `timestamp()`, seconds.
template <typename Past>
class FrameHistory {
 public:
  /// The newest frame, with the contents of a dropped one or of a new Past: to be filled in by the caller.
  Past& add() {
    if (spare_.empty()) spare_.emplace_back();
    frames_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    return frames_.back();
  }

  /// Drops the frames before this time, seconds.
  void drop_before(double timestamp) {
    while (!frames_.empty() && frames_.front().timestamp() < timestamp) drop_oldest();
  }
  void clear() {
    while (!frames_.empty()) drop_oldest();
  }

  auto begin() { return frames_.begin(); }
  auto end() { return frames_.end(); }
  bool empty() const { return frames_.empty(); }

 private:
  void drop_oldest() {
    spare_.push_back(std::move(frames_.front()));
    frames_.pop_front();
  }

  std::deque<Past> frames_;
  std::vector<Past> spare_;
};

DOT_END_NAMESPACE
