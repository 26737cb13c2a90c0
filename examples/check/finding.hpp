// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace check {

/// A hint is what is mostly wrong, but may be right: it is said like a fault, and is none.
enum class Verdict : std::uint8_t { Fine, Fault, Hint, Unknown };

/// What was measured of one property of a recording.
struct Finding {
  std::string fault;  ///< name of what could be wrong, such as "depth-lag"; docs/check.md lists them
  Verdict verdict = Verdict::Fine;
  double figure = 0;   ///< NaN where nothing could be measured
  std::string unit;    ///< of the figure
  std::string words;   ///< what was found, a sentence
  std::string advice;  ///< what to do about a fault or a hint
};

using Findings = std::vector<Finding>;

Finding fine(std::string fault, double figure, std::string unit, std::string words);
Finding faulty(std::string fault, double figure, std::string unit, std::string words, std::string advice);
Finding hint(std::string fault, double figure, std::string unit, std::string words, std::string advice);
/// @param why it could not be measured.
Finding unknown(std::string fault, std::string why);

const char* to_string(Verdict verdict);

}  // namespace check
