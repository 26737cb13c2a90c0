// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "dataset/sequence_list.hpp"
#include "network/network.hpp"
#include "run/run_options.hpp"
#include "run/writer.hpp"

namespace runner {

/// What a run is to leave behind; an empty path: not that.
struct OutputPaths {
  OutputOptions results;
  std::filesystem::path video;   ///< of the overlay
  std::filesystem::path player;  ///< page to look at the run
};

/// Many sequences instead of one.
struct DataSet {
  std::filesystem::path list;  ///< empty: one sequence
  dataset::Shard shard;
  int jobs = 1;         ///< sequences side by side
  bool resume = false;  ///< complete ones are not done again
};

/// A look at the recording instead of a run.
struct CheckOptions {
  bool wanted = false;
  std::filesystem::path html;  ///< page to write; empty: none
  bool json = false;           ///< the report on standard output as JSON
};

struct Arguments {
  RunOptions run;
  CheckOptions check;
  OutputPaths output;
  int mask_delay = 0;                     ///< frames
  network::NetworkOptions network;        ///< without a model: the masks of the sequence
  std::optional<double> network_seconds;  ///< that a network takes at least
  bool real_time = false;
  std::optional<double> fps;  ///< of the frames in real time; absent: by their timestamps
  DataSet data_set;
  std::map<std::string, std::string> given;  ///< the options as they stand on the command line
  bool help = false;
};

/// What `--help` prints.
std::string usage();

/// @throws UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

}  // namespace runner
