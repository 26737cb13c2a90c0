// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "finding.hpp"

#include <limits>
#include <utility>

namespace check {

Finding fine(std::string fault, double figure, std::string unit, std::string words) {
  return {std::move(fault), Verdict::Fine, figure, std::move(unit), std::move(words), {}};
}

Finding faulty(std::string fault, double figure, std::string unit, std::string words, std::string advice) {
  return {std::move(fault), Verdict::Fault, figure, std::move(unit), std::move(words), std::move(advice)};
}

Finding hint(std::string fault, double figure, std::string unit, std::string words, std::string advice) {
  return {std::move(fault), Verdict::Hint, figure, std::move(unit), std::move(words), std::move(advice)};
}

Finding unknown(std::string fault, std::string why) {
  return {std::move(fault), Verdict::Unknown, std::numeric_limits<double>::quiet_NaN(), {}, std::move(why), {}};
}

const char* to_string(Verdict verdict) {
  if (verdict == Verdict::Fault) return "fault";
  if (verdict == Verdict::Hint) return "hint";
  return verdict == Verdict::Fine ? "fine" : "not measured";
}

}  // namespace check
