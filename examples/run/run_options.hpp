// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "command_line.hpp"
#include "dot/pipeline/options.hpp"
#include "sequence/recording.hpp"

namespace runner {

/// What programs that run the tracker over sequences have in common on their command lines.
struct RunOptions {
  SequenceOptions sequence;
  std::filesystem::path config;
  std::optional<dot::ClassifierKind> classifier;
  bool discover = false;       ///< look for moving things that no mask shows
  std::optional<int> threads;  ///< of OpenCV's pool
};

/// Lines of `--help` for these options.
extern const char* const run_options_usage;

/// Makes `line` fill in `options`: the tracker's settings and the sequence's, but for its folder and mask rate.
void add_run_options(CommandLine& line, RunOptions& options);

/// Defaults, then the depth source that the sequence says, then the configuration file, then the command line.
/// @throws FileError naming the line of the configuration, std::invalid_argument naming the setting.
dot::Options tracker_options(const RunOptions& options, dot::DepthSource source);

}  // namespace runner
