// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "object_score.hpp"
#include "run/run_options.hpp"

namespace eval {

struct Arguments {
  runner::RunOptions run;  ///< for every sequence; its folder is not set
  std::vector<std::filesystem::path> sequences;
  std::vector<std::string> names;  ///< of the sequences, each different
  std::vector<int> rates{1};
  std::filesystem::path out;   ///< files like dot_run's; empty: none
  std::filesystem::path html;  ///< empty: none
  std::filesystem::path json;  ///< empty: none
  int jobs = 1;
  bool hide_movers = false;
  std::optional<double> boxes;  ///< boxes instead of masks, with this margin, see boxes.hpp
  bool compare = false;         ///< with the rules of published systems, see compare.hpp
  int starts = 0;        ///< start a tracker at every so many frames, see starts.hpp; 0: evaluate whole sequences
  int start_frames = 8;  ///< frames after each start
  int drop_largest = 0;  ///< frames after each start in which the largest mover has no mask
  std::vector<int>
      network_delays;  ///< ms that a network takes for a frame, ascending, see network_delay.hpp; empty: no delay
  std::filesystem::path plot;  ///< of the delays; empty: none
  ObjectScoring scoring;
  bool help = false;
};

/// What `--help` prints.
std::string usage();

/// @throws runner::UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

}  // namespace eval
