// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "network/network.hpp"
#include "run/run_options.hpp"
#include "run/writer.hpp"

namespace runner {

struct Arguments {
  RunOptions run;
  OutputOptions output;
  int mask_delay = 0;                     ///< frames
  network::NetworkOptions network;        ///< without a model: the masks of the sequence
  std::optional<double> network_seconds;  ///< that a network takes at least
  bool real_time = false;
  std::optional<double> fps;  ///< of the frames in real time; absent: by their timestamps
  bool help = false;
};

/// What `--help` prints.
std::string usage();

/// @throws UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

}  // namespace runner
