// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <opencv2/core.hpp>
#include <string>

namespace check {

inline std::string text(int value) { return std::to_string(value); }

/// With so many digits behind the point.
inline std::string number(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

/// "1 frame", "2 frames".
inline std::string count_text(int count, const std::string& noun) {
  return text(count) + " " + noun + (count == 1 ? "" : "s");
}

inline std::string size_text(cv::Size size) { return text(size.width) + "x" + text(size.height); }

}  // namespace check
