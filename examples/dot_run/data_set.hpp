// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "arguments.hpp"

namespace runner {

/// What the run of a sequence of a data set says, in its folder of results; who writes there keeps it.
constexpr const char* log_name = "run.log";

/// Runs all sequences of Arguments::data_set, each in a process of its own, with its results in a folder of its own,
/// and writes a table of what has become of them. docs/datasets.md has the names.
/// @param stop set by a signal: the sequences that run end after their frame, and no other begins.
/// @return the program's exit status.
/// @throws UsageError when complete results were made otherwise than is asked for now, or would go to a sequence's own
/// folder, FileError when the list cannot be read or the table cannot be written.
int run_data_set(const Arguments& arguments, std::atomic<bool>& stop);

}  // namespace runner
