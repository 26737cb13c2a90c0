// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"
#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"

namespace eval {

/// The first frames after a start, counted from the second one on. Objects of 200 pixels and more count. Movers count
/// from the least speed on, or with an unknown speed.
struct StartScore {
  int starts = 0;
  int standing = 0, standing_moving = 0, standing_static = 0;  ///< objects in frames; of these labelled so
  int moving = 0, moving_moving = 0, moving_static = 0;
  int intervals = 0;  ///< the first three of each start
  int wrong = 0;      ///< of these: camera motion wrong by more than max(0.1 m, 15 %)
  int silent = 0;     ///< of these: objects were decided all the same

  void add(const StartScore& other);
  /// The objects of one frame. @return how many of them are labelled static or moving.
  int add(const runner::TruthEntry& truth, const cv::Mat& instance, const dot::Result& result, double min_speed);
  /// The camera's motion over one interval; both are T_cur_prev.
  void add(const Eigen::Matrix4d& truth, const Eigen::Matrix4d& estimate, bool decided);
};

/// The true mover with the most pixels in a frame; -1 if there is none of that speed or of an unknown one.
int largest_mover(const runner::TruthEntry& truth, const cv::Mat& instance, double min_speed);

struct StartRun {
  std::string name;
  std::string error;  ///< empty when the sequence could be measured
  StartScore score;
};

/// Starts a tracker at every Arguments::starts-th frame of each sequence, for Arguments::start_frames frames.
/// Arguments::drop_largest leaves the mask of the largest mover out of the first frames.
std::vector<StartRun> evaluate_starts(const Arguments& arguments);

/// A row for each sequence and the pooled one, for a terminal.
std::string start_table(const std::vector<StartRun>& runs);

}  // namespace eval
