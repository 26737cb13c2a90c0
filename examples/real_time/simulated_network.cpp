// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "simulated_network.hpp"

#include <utility>

namespace real_time {
namespace {

constexpr double clock_error = 1e-6;  // seconds, of timestamps in text files

}  // namespace

void SimulatedNetwork::start(const FramePtr& frame, double now) {
  running_ = LateSegmentation{frame->number, frame->timestamp, now + seconds_, segment_(*frame)};
}

void SimulatedNetwork::offer(const FramePtr& frame) {
  std::vector<LateSegmentation> done = take(frame->timestamp);
  done_ = std::move(done);
  if (!running_) return start(frame, frame->timestamp);
  if (waiting_) ++skipped_;
  waiting_ = frame;
}

std::vector<LateSegmentation> SimulatedNetwork::take(double now) {
  while (running_ && running_->done <= now + clock_error) {
    const double done = running_->done;
    done_.push_back(std::move(*running_));
    running_.reset();
    if (const FramePtr next = std::exchange(waiting_, nullptr)) start(next, done);
  }
  return std::exchange(done_, {});
}

}  // namespace real_time
