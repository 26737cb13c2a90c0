// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "evaluate.hpp"

namespace eval {

/// All runs of one mask rate together. Object-frames and pixels of hidden movers are added up; the mask IoU and its
/// ratio to the first rate are means over the sequences that have movers; camera figures are those of the worst one.
struct Pooled {
  int every = 1;
  int runs = 0;
  int failed = 0;
  Confusion confusion;
  std::array<Band, band_count> bands;
  AnswersBySpeed by_speed{};
  Confusion turning;
  double mask_iou = not_a_number;
  double iou_ratio_mean = not_a_number;
  double iou_ratio_min = not_a_number;
  double instance_iou = not_a_number;
  int id_switches = 0;
  double near_speed_error = not_a_number;       ///< median of movers under 30 m, m/s
  double near_motion_error_m = not_a_number;    ///< likewise
  double near_motion_error_deg = not_a_number;  ///< likewise
  double speed_coverage = not_a_number;         ///< of the worst run, as the next two
  double sigma_coverage = not_a_number;
  double motion_coverage = not_a_number;
  double rpe_trans_median_cm = not_a_number;
  double rpe_trans_cm = not_a_number;
  double rpe_trans_max_cm = not_a_number;
  double rpe_rot_median_deg = not_a_number;
  double ate_m = not_a_number;
  double camera_nees = not_a_number;  ///< per axis, median of the runs: recorded poses are seldom true enough
  std::vector<LatencyEvent> latency;
  HiddenScore hidden;
  StageTimes stage_ms{};  ///< means over the runs
  FrameTime frame_time;   ///< means over the runs, but p99, largest and second of the worst
};

/// @param runs all of them; those with an error count as failed.
/// @param first_rate the rate that mask IoUs are compared with.
Pooled pool(const std::vector<RunScore>& runs, int every, int first_rate);

}  // namespace eval
