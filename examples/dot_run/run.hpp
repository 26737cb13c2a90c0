// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "arguments.hpp"
#include "dataset/record.hpp"

namespace runner {

constexpr int status_of_interrupted = 130;  ///< of the program, as shells have it

struct RunEnd {
  bool complete = false;  ///< all frames are done; the tables keep their names of incomplete ones otherwise
  dataset::Figures figures;
};

/// Tracks the sequence, writes the results and prints a summary.
/// @param stop set by a signal: the run ends after its frame.
RunEnd run(const Arguments& arguments, std::atomic<bool>& stop);

}  // namespace runner
