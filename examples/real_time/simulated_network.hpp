// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "late_segmentation.hpp"

namespace real_time {

/// A network that takes a given time for a frame, in the time of the sequence: the results do not depend on the
/// machine. It works on one frame at a time. The newest frame that comes meanwhile waits; those before it are skipped.
class SimulatedNetwork {
 public:
  /// @param seconds for each frame.
  SimulatedNetwork(double seconds, FrameSegmenter segment) : seconds_(seconds), segment_(std::move(segment)) {}

  /// Hands over a frame when it comes. @param frame its timestamp must not be before that of the last one.
  void offer(const FramePtr& frame);

  /// The segmentations that are done at that time, the oldest first.
  std::vector<LateSegmentation> take(double now);

  int skipped() const { return skipped_; }

 private:
  void start(const FramePtr& frame, double now);

  double seconds_;
  FrameSegmenter segment_;
  std::optional<LateSegmentation> running_;
  FramePtr waiting_;
  std::vector<LateSegmentation> done_;
  int skipped_ = 0;
};

}  // namespace real_time
