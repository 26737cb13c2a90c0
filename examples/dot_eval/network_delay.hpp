// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pool.hpp"

namespace eval {

/// All sequences with masks as late as a network's.
struct DelayScore {
  std::optional<double> network_seconds;  ///< none: the masks come with their frames
  Pooled pooled;
  int frames = 0;
  std::vector<double> mask_latency;  ///< seconds from frame to masks, of those that were used
  int refused = 0;                   ///< segmentations that came too late for the tracker
};

/// All sequences without a delay, then with each of Arguments::network_delays.
std::vector<Job> delay_jobs(const Arguments& arguments);

/// @param runs of delay_jobs, in their order.
std::vector<DelayScore> pool_delays(const Arguments& arguments, const std::vector<RunScore>& runs);

/// A row for each delay, and what failed.
std::string delay_table(const std::vector<RunScore>& runs, const std::vector<DelayScore>& scores);

/// F1, mask IoU and decided share against the network's time for a frame, a whole SVG file.
std::string delay_plot(const std::vector<DelayScore>& scores);

}  // namespace eval
