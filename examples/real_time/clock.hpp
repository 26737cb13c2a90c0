// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace real_time {

/// The time that a run goes by. Several threads may use it.
class Clock {
 public:
  virtual ~Clock() = default;

  /// Seconds since an arbitrary moment.
  virtual double now() const = 0;

  /// Waits until that time, or until `stop` is set.
  /// @return whether the time has come.
  virtual bool sleep_until(double seconds, const std::atomic<bool>& stop) = 0;
};

/// The machine's monotonic clock.
class SteadyClock : public Clock {
 public:
  double now() const override;
  bool sleep_until(double seconds, const std::atomic<bool>& stop) override;
};

}  // namespace real_time
