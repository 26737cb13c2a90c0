// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <cstdio>

#include "run/percentile.hpp"

namespace real_time {

std::string median_and_p99(const std::vector<double>& values, double ms_per_unit) {
  char text[64];
  std::snprintf(text, sizeof text, "median %.1f ms, p99 %.1f ms", ms_per_unit * runner::percentile(values, 50),
                ms_per_unit * runner::percentile(values, 99));
  return text;
}

int Report::unfinished() const { return offered - skipped - refused - static_cast<int>(mask_latency.size()); }

std::string Report::text() const {
  std::string text;
  if (!frame_latency.empty()) {
    text += "real time " + std::to_string(frames) + " frames came, " + std::to_string(tracked) + " tracked, " +
            std::to_string(frames - tracked) + " dropped; from frame to result " + median_and_p99(frame_latency, 1000) +
            "\n";
    if (late_reads > 0)
      text +=
          "          " + std::to_string(late_reads) + " frames were read too late: reading is slower than the camera\n";
  }
  if (offered > 0) {
    const auto used = mask_latency.size();
    text += "late      masks of " + std::to_string(offered - skipped) + " frames: " + std::to_string(used) + " used, " +
            std::to_string(refused) + " too late, " + std::to_string(unfinished()) + " not done at the end; " +
            std::to_string(skipped) + " frames skipped by the network\n";
    if (used > 0) text += "          from frame to masks " + median_and_p99(mask_latency, 1000) + "\n";
  }
  return text;
}

}  // namespace real_time
