// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "arguments.hpp"

namespace runner {

/// Tracks the sequence, writes the results and prints a summary.
/// @param stop set by a signal: the run ends after its frame.
/// @return whether all frames are done; the tables keep their names of incomplete ones otherwise.
bool run(const Arguments& arguments, std::atomic<bool>& stop);

}  // namespace runner
