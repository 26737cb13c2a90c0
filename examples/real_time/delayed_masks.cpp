// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "delayed_masks.hpp"

#include <utility>

namespace real_time {

DelayedMasks::DelayedMasks(LateNetwork network, dot::Tracker& tracker)
    : network_(std::move(network)), simulated_(network_.seconds, network_.segment), feed_(tracker) {}

dot::Frame DelayedMasks::next(const FramePtr& frame) {
  for (const LateSegmentation& late : simulated_.take(frame->timestamp)) feed_.submit(late);
  ++frames_;
  if (network_.takes(*frame)) {
    ++offered_;
    simulated_.offer(frame);
  }
  dot::Frame now = frame->frame();
  now.masks.reset();
  return now;
}

Report DelayedMasks::report() const {
  Report report;
  report.frames = report.tracked = frames_;
  report.offered = offered_;
  report.skipped = simulated_.skipped();
  report.refused = feed_.refused();
  report.mask_latency = feed_.latencies();
  return report;
}

LateNetwork recorded_masks(double seconds) {
  // A copy: threads share no cv::Mat, whose count of owners the thread sanitizer does not see.
  const auto segment = [](const runner::SequenceFrame& frame) {
    return runner::Segmentation{frame.ids.clone(), frame.instances};
  };
  return {segment, [](const runner::SequenceFrame& frame) { return !frame.ids.empty(); }, seconds};
}

}  // namespace real_time
