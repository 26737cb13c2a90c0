// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "starts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>

#include "dot/tracker.hpp"
#include "evaluate.hpp"
#include "hidden_movers.hpp"
#include "sequence/errors.hpp"
#include "statistics.hpp"

namespace eval {
namespace {

constexpr long kMinArea = 200;        // pixels
constexpr double kMinLabelled = 0.3;  // of an object's pixels
constexpr int kIntervals = 3;

/// Pixels of each true instance, by label; [0] counts the pixels without one.
std::map<int, std::array<long, 4>> count_labels(const cv::Mat& instance, const dot::Result& result) {
  std::map<int, std::array<long, 4>> counts;
  for (int y = 0; y < instance.rows; ++y)
    for (int x = 0; x < instance.cols; ++x)
      if (const int id = instance.at<int>(y, x); id != 0) ++counts[id][result.labels(x, y)];
  return counts;
}

bool counts_as_mover(const runner::TrueObject& object, double min_speed) {
  return object.moving && (object.speed < 0 || object.speed >= min_speed);
}

/// One start, at frame `first`.
void start(const Arguments& arguments, runner::Sequence& sequence, int first, StartScore& score) {
  const auto truth_of = [&](int index) -> const runner::TruthEntry& {
    return sequence.recording().entries[static_cast<std::size_t>(index)].truth;
  };
  dot::Tracker tracker(sequence.intrinsics(), tracker_options(arguments.run, sequence.depth_source()));
  const double min_speed = arguments.scoring.min_speed;
  std::optional<int> dropped;
  ++score.starts;
  for (int f = 0; f < arguments.start_frames; ++f) {
    const runner::TruthEntry& truth = truth_of(first + f);
    const cv::Mat instance = sequence.truth(first + f).instance;
    runner::SequenceFrame frame = sequence.read(first + f);
    if (f % arguments.rates[0] != 0) frame.ids.release(), frame.instances.clear();
    if (f < arguments.drop_largest) {
      if (!dropped || *dropped < 0) dropped = largest_mover(truth, instance, min_speed);
      remove_movers({*dropped}, instance, frame);
    }
    const dot::Result& result = tracker.track(frame.frame());
    if (f == 0) continue;
    const int decided = score.add(truth, instance, result, min_speed);
    const auto& before = truth_of(first + f - 1).camera;
    if (f <= kIntervals && truth.camera && before)
      score.add(truth.camera->inverse() * *before, runner::pose_from_row_major(result.camera.T_cur_prev.data()),
                decided > 0);
  }
}

std::string row(const std::string& name, const StartScore& s) {
  char counts[64];
  std::snprintf(counts, sizeof counts, "%-20s %6d", name.c_str(), s.starts);
  const auto share = [](int part, int all) {
    char text[16];
    std::snprintf(text, sizeof text, all > 0 ? " %9.4f" : "         -", ratio(part, all));
    return std::string(text);
  };
  return counts + share(s.standing_moving, s.standing) + share(s.standing_static, s.standing) +
         share(s.moving_moving, s.moving) + share(s.moving_static, s.moving) + share(s.wrong, s.intervals) +
         share(s.silent, s.intervals) + "\n";
}

}  // namespace

void StartScore::add(const StartScore& other) {
  starts += other.starts;
  standing += other.standing, standing_moving += other.standing_moving, standing_static += other.standing_static;
  moving += other.moving, moving_moving += other.moving_moving, moving_static += other.moving_static;
  intervals += other.intervals, wrong += other.wrong, silent += other.silent;
}

int StartScore::add(const runner::TruthEntry& truth, const cv::Mat& instance, const dot::Result& result,
                    double min_speed) {
  int decided = 0;
  for (const auto& [id, labels] : count_labels(instance, result)) {
    const auto object = truth.objects.find(id);
    const long labelled = labels[1] + labels[2] + labels[3], area = labels[0] + labelled;
    if (object == truth.objects.end() || area < kMinArea) continue;
    const auto most = std::max_element(labels.begin() + 1, labels.end()) - labels.begin();
    const bool known = static_cast<double>(labelled) > kMinLabelled * static_cast<double>(area);
    const bool is_static = known && most == static_cast<int>(dot::State::Static),
               is_moving = known && most == static_cast<int>(dot::State::Moving);
    decided += is_static || is_moving;
    if (!object->second.moving)
      ++standing, standing_moving += is_moving, standing_static += is_static;
    else if (counts_as_mover(object->second, min_speed))
      ++moving, moving_moving += is_moving, moving_static += is_static;
  }
  return decided;
}

void StartScore::add(const Eigen::Matrix4d& truth, const Eigen::Matrix4d& estimate, bool decided) {
  const Eigen::Matrix4d error = truth.inverse() * estimate;
  const double metres = error.topRightCorner<3, 1>().norm(), way = truth.topRightCorner<3, 1>().norm();
  const bool is_wrong = metres > std::max(0.1, 0.15 * way);
  ++intervals;
  wrong += is_wrong;
  silent += is_wrong && decided;
}

int largest_mover(const runner::TruthEntry& truth, const cv::Mat& instance, double min_speed) {
  std::map<int, long> areas;
  for (int y = 0; y < instance.rows; ++y)
    for (int x = 0; x < instance.cols; ++x) ++areas[instance.at<int>(y, x)];
  int largest = -1;
  for (const auto& [id, object] : truth.objects)
    if (counts_as_mover(object, min_speed) && areas[id] > 0 && (largest < 0 || areas[id] > areas[largest]))
      largest = id;
  return largest;
}

std::vector<StartRun> evaluate_starts(const Arguments& arguments) {
  std::vector<StartRun> runs;
  for (std::size_t i = 0; i < arguments.sequences.size(); ++i) {
    StartRun& run = runs.emplace_back();
    run.name = arguments.names[i];
    try {
      runner::SequenceOptions source = arguments.run.sequence;
      source.folder = arguments.sequences[i];
      source.truth = true;
      runner::Sequence sequence(source);
      if (!has_truth(sequence.recording())) throw runner::FileError(source.folder.string() + ": has no ground truth");
      if (sequence.size() < arguments.start_frames)
        throw runner::FileError(source.folder.string() + ": has fewer frames than --start-frames " +
                                std::to_string(arguments.start_frames));
      for (int first = 0; first + arguments.start_frames <= sequence.size(); first += arguments.starts)
        start(arguments, sequence, first, run.score);
    } catch (const std::exception& error) {
      run.error = error.what();
    }
  }
  return runs;
}

std::string start_table(const std::vector<StartRun>& runs) {
  std::string out =
      "S standing, M moving, >M called moving, >S called static; camera: wrong intervals, and those not told\n"
      "sequence             starts       S>M       S>S       M>M       M>S    camera    silent\n";
  StartScore pooled;
  for (const StartRun& run : runs) {
    out += run.error.empty() ? row(run.name, run.score) : run.name + " FAILED: " + run.error + "\n";
    pooled.add(run.score);
  }
  return out + row("POOLED", pooled);
}

}  // namespace eval
