// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "clock.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace real_time {

double SteadyClock::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool SteadyClock::sleep_until(double seconds, const std::atomic<bool>& stop) {
  constexpr double longest = 0.02;  // a stop is noticed so soon
  while (!stop) {
    const double left = seconds - now();
    if (left <= 0) return true;
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, longest)));
  }
  return false;
}

}  // namespace real_time
