// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// What has to be found, compiled, linked and run: the compiled tier.

#include <cstdio>
#include <stdexcept>

#include "dot/tracker.hpp"
#include "dot/version.hpp"

int main() {
  dot::Tracker({100, 100, 79.5, 59.5, 160, 120, 0});
  try {
    dot::Tracker(dot::Intrinsics{});
  } catch (const std::invalid_argument& error) {
    std::printf("dot %s; %s\n", DOT_VERSION_STRING, error.what());
    return 0;
  }
  return 1;
}
