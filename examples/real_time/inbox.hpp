// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <variant>

#include "late_segmentation.hpp"

namespace real_time {

/// A frame and when it came.
struct Arrival {
  FramePtr frame;
  double time = 0;  ///< of the clock, seconds
};

/// What comes to the thread that tracks: the newest frame and the masks of earlier ones. All functions may be called by
/// any thread.
class Inbox {
 public:
  using Item = std::variant<LateSegmentation, Arrival>;

  /// A frame that still waits is dropped.
  void put(Arrival arrival);
  void put(LateSegmentation late);
  /// No more frames will come.
  void close();
  /// A thread has failed; `take` throws its exception. The first one counts.
  void fail(std::exception_ptr error);

  /// Waits. Masks come before the frame, because they belong to earlier ones.
  /// @return none when the inbox is closed and empty.
  /// @throws the exception given to `fail`.
  std::optional<Item> take();

  /// @throws the exception given to `fail`, if there is one.
  void check() const;

  int dropped() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<LateSegmentation> masks_;
  std::optional<Arrival> frame_;
  std::exception_ptr error_;
  bool closed_ = false;
  int dropped_ = 0;
};

}  // namespace real_time
