// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/run_options.hpp"

namespace slam {

struct Arguments {
  runner::RunOptions run;  ///< of each sequence; `sequence.folder` is left to the caller
  std::vector<std::filesystem::path> sequences;
  int seeds = 5;
  int features = 1500;
  bool help = false;
};

/// What `--help` prints.
std::string usage();

/// @throws UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

}  // namespace slam
