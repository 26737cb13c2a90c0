// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "camera_score.hpp"
#include "dot/pipeline/result.hpp"
#include "hidden_movers.hpp"
#include "latency.hpp"
#include "object_score.hpp"
#include "pictures.hpp"
#include "real_time/report.hpp"

namespace eval {

constexpr std::size_t stage_count = static_cast<std::size_t>(dot::Stage::Count);
using StageTimes = std::array<double, stage_count>;

/// One sequence at one mask rate.
struct Job {
  std::size_t sequence = 0;  ///< index of Arguments::sequences
  int every = 1;
  std::optional<double> network_seconds;  ///< masks come as late as from a network that takes so long
};

/// What one sequence at one mask rate comes to.
struct RunScore {
  std::string name;
  int every = 1;
  std::optional<double> network_seconds;
  std::string error;  ///< why there is nothing else; empty when there is
  int frames = 0;
  std::optional<ObjectScore> objects;  ///< absent: no true instances
  std::optional<CameraScore> camera;   ///< absent: no true poses
  std::vector<LatencyEvent> latency;
  std::optional<HiddenScore> hidden;
  real_time::Report late;         ///< where masks come late
  StageTimes stage_ms{};          ///< means, without the first frame
  std::vector<double> frame_ms;   ///< all of `track`, of each frame but the first
  std::vector<Picture> pictures;  ///< where Arguments::html asks for them
};

/// Time in `track` over the frames of a run but the first, ms.
struct FrameTime {
  double mean = not_a_number, median = not_a_number, p99 = not_a_number, largest = not_a_number;
  double second = not_a_number;  ///< of the second frame, which finds the first motions of all
};

FrameTime frame_time(const std::vector<double>& frame_ms);

/// Whether there is anything to compare answers with.
bool has_truth(const runner::Recording& recording);

/// Called after each frame with the number done and of all.
using FrameDone = std::function<void(int done, int total)>;

/// Runs and measures. Whatever fails becomes RunScore::error.
RunScore evaluate(const Arguments& arguments, const Job& job, const FrameDone& frame_done);

}  // namespace eval
