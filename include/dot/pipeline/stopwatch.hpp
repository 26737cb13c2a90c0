// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace dot {

/// Times the stages of a frame.
class Stopwatch {
 public:
  /// Begins the first stage.
  void start() { last_ = Clock::now(); }

  /// Milliseconds since the last call.
  double lap() {
    const auto now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_{};
};

}  // namespace dot
