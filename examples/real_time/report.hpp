// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace real_time {

/// How a run with a network beside the tracker went. Times in seconds.
struct Report {
  int frames = 0;                    ///< that came
  int tracked = 0;                   ///< the others were dropped, because a newer one came before the tracker was ready
  int late_reads = 0;                ///< frames that could not be read in time
  int offered = 0;                   ///< to the network
  int skipped = 0;                   ///< of these not segmented, because a newer one came before the network was ready
  int refused = 0;                   ///< segmentations that came too late for the tracker
  std::vector<double> mask_latency;  ///< from frame to masks, of the segmentations that were used
  std::vector<double> frame_latency;  ///< from frame to result; empty where time is simulated

  /// Segmentations that were not done at the end.
  int unfinished() const;

  /// Lines for the summary of a run.
  std::string text() const;
};

/// "median 8.1 ms, p99 12.0 ms". @param ms_per_unit 1000 for seconds.
std::string median_and_p99(const std::vector<double>& values, double ms_per_unit);

}  // namespace real_time
