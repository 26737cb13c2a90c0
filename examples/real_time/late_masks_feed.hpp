// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/tracker.hpp"
#include "late_segmentation.hpp"

namespace real_time {

/// Hands late masks to a tracker and keeps account of them.
class LateMasksFeed {
 public:
  explicit LateMasksFeed(dot::Tracker& tracker) : tracker_(tracker) {}

  /// @return whether the tracker has taken them. It does not when they come too late (Options::mask.late_seconds,
  /// late_frames), or when it has forgotten their frame.
  /// @throws what submit_masks throws for masks that are wrong.
  bool submit(const LateSegmentation& late);

  int refused() const { return refused_; }
  /// Seconds from frame to masks, of those that were taken.
  const std::vector<double>& latencies() const { return latencies_; }

 private:
  dot::Tracker& tracker_;
  int refused_ = 0;
  std::vector<double> latencies_;
};

}  // namespace real_time
