// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"
#include "evaluate.hpp"

namespace eval {

/// The tracker, or a rule of a published system, over all sequences.
struct Contender {
  std::string name;
  std::string source;          ///< of the rule and its thresholds
  std::vector<RunScore> runs;  ///< a sequence each
};

/// Runs the tracker over the sequences, and has the rules of examples/peers decide the masks that it gives out, with
/// the true camera motion. The tracker comes first. What fails in a sequence is an error in each of its runs.
/// @throws runner::UsageError when the rules are not built in.
std::vector<Contender> compare(const Arguments& arguments);

/// A table of the sequences pooled, and one of the moving F1 by sequence.
std::string compare_table(const std::vector<Contender>& contenders, int every);

}  // namespace eval
