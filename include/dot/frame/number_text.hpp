// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace dot {

/// Formats a number for a message, without trailing zeros, and with a point in any locale.
inline std::string to_text(double value, int digits = 6) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}

/// Formats a time in seconds for a message: a Unix clock with its microseconds.
inline std::string time_text(double seconds) { return to_text(seconds, 16); }

}  // namespace dot
