// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "clock.hpp"
#include "inbox.hpp"

namespace real_time {

/// Stands for a camera: reads the frames of a recording in a thread of its own and puts each into an inbox when its
/// time has come. It reads one frame ahead. If it fails, the inbox does.
class CameraThread {
 public:
  using Reader = std::function<runner::SequenceFrame(int index)>;

  /// @param times of the frames, seconds from the first one.
  /// @param stop set by anyone, a signal's handler for instance: no further frames, and the inbox is closed.
  /// Clock, stop and inbox must live longer.
  CameraThread(Reader read, std::vector<double> times, Clock& clock, std::atomic<bool>& stop, Inbox& inbox);
  /// Sets `stop` if frames are left.
  ~CameraThread();
  CameraThread(const CameraThread&) = delete;
  CameraThread& operator=(const CameraThread&) = delete;

  /// Frames that could not be read by their time, because the disk or the stereo matching is too slow.
  int late() const { return late_; }

 private:
  void work();

  Reader read_;
  std::vector<double> times_;
  Clock& clock_;
  std::atomic<bool>& stop_;
  Inbox& inbox_;
  std::atomic<bool> done_{false};
  std::atomic<int> late_{0};
  std::thread thread_;  // the last: it uses all others
};

}  // namespace real_time
