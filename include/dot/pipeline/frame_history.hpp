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

  /// Drops the frames before this time, seconds, and the oldest of more than `most`.
  void drop_before(double timestamp, std::size_t most) {
    while (!frames_.empty() && (frames_.front().timestamp() < timestamp || frames_.size() > most)) frames_.pop_front();
  }
  /// Drops all frames up to one of them, and that one.
  void drop_through(const Past& last) {
    for (bool found = false; !found && !frames_.empty(); frames_.pop_front()) found = &frames_.front() == &last;
  }
  void clear() noexcept { frames_.clear(); }

  auto begin() { return frames_.begin(); }
  auto end() { return frames_.end(); }
  std::size_t size() const { return frames_.size(); }
  bool empty() const { return frames_.empty(); }

 private:
  RecyclingList<Past> frames_;
};

DOT_END_NAMESPACE
