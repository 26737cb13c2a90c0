// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "run/run_options.hpp"
#include "run_writer.hpp"

namespace runner {

struct Arguments {
  RunOptions run;
  Outputs output;
  int mask_delay = 0;  ///< frames
  bool help = false;
};

/// What `--help` prints.
std::string usage();

/// @throws UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

}  // namespace runner
