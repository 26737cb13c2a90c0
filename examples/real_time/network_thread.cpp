// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "network_thread.hpp"

#include <exception>
#include <utility>

namespace real_time {

NetworkThread::NetworkThread(FrameSegmenter segment, double seconds, Clock& clock, Inbox& inbox)
    : segment_(std::move(segment)), seconds_(seconds), clock_(clock), inbox_(inbox), thread_([this] { work(); }) {}

void NetworkThread::finish() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void NetworkThread::offer(Arrival arrival) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_) ++skipped_;
    waiting_ = std::move(arrival);
  }
  changed_.notify_one();
}

int NetworkThread::skipped() const {
  const std::lock_guard lock(mutex_);
  return skipped_;
}

std::optional<Arrival> NetworkThread::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return stop_ || waiting_; });
  if (stop_) return std::nullopt;
  return std::exchange(waiting_, std::nullopt);
}

void NetworkThread::work() {
  try {
    while (const std::optional<Arrival> arrival = next()) {
      const double start = clock_.now();
      runner::Segmentation segmentation = segment_(*arrival->frame);
      if (!clock_.sleep_until(start + seconds_, stop_)) return;
      inbox_.put(LateSegmentation{arrival->frame->number, arrival->time, clock_.now(), std::move(segmentation)});
    }
  } catch (...) {
    inbox_.fail(std::current_exception());
  }
}

}  // namespace real_time
