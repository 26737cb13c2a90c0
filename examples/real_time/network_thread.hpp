// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "clock.hpp"
#include "inbox.hpp"

namespace real_time {

/// Segments the newest frame in a thread of its own and puts the masks into an inbox. If it fails, the inbox does.
class NetworkThread {
 public:
  /// @param seconds that a frame takes at least. Clock and inbox must live longer.
  NetworkThread(FrameSegmenter segment, double seconds, Clock& clock, Inbox& inbox);
  ~NetworkThread() { finish(); }
  NetworkThread(const NetworkThread&) = delete;
  NetworkThread& operator=(const NetworkThread&) = delete;

  /// A frame that still waits is skipped.
  void offer(Arrival arrival);

  /// Waits for the frame that is being segmented; one that waits is not.
  void finish();

  int skipped() const;

 private:
  void work();
  std::optional<Arrival> next();

  FrameSegmenter segment_;
  double seconds_;
  Clock& clock_;
  Inbox& inbox_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Arrival> waiting_;
  int skipped_ = 0;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // the last: it uses all others
};

}  // namespace real_time
