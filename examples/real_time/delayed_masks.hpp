// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "late_masks_feed.hpp"
#include "report.hpp"
#include "simulated_network.hpp"

namespace real_time {

/// A tracker's frames with a simulated network beside it, one after the other in the time of the sequence.
class DelayedMasks {
 public:
  /// @param network its seconds are those of the sequence. @param tracker must live longer.
  DelayedMasks(LateNetwork network, dot::Tracker& tracker);

  /// Before a frame is tracked: submits the masks that are done by then, and hands the frame to the network.
  /// @return the frame to track, which has no masks yet.
  dot::Frame next(const FramePtr& frame);

  Report report() const;

 private:
  LateNetwork network_;
  SimulatedNetwork simulated_;
  LateMasksFeed feed_;
  int frames_ = 0;
  int offered_ = 0;
};

/// The masks of the frames themselves, as a network that takes `seconds`.
LateNetwork recorded_masks(double seconds);

}  // namespace real_time
