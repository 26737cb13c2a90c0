// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "hidden_movers.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace eval {
namespace {

constexpr int first_counted = 6;
constexpr long min_area = 1000;  // pixels

}  // namespace

void HiddenScore::add(const HiddenScore& other) {
  movers += other.movers;
  pixels += other.pixels;
  found += other.found;
  standing += other.standing;
  false_alarm += other.false_alarm;
  moving += other.moving;
}

HiddenMovers::HiddenMovers(const runner::Recording& recording, const ObjectScoring& scoring) : scoring_(scoring) {
  std::set<int> movers;
  for (const runner::RecordingEntry& entry : recording.entries)
    for (const auto& [id, object] : entry.truth.objects)
      if (object.moving) movers.insert(id);
  const bool has_masks = std::any_of(recording.entries.begin(), recording.entries.end(),
                                     [](const auto& entry) { return !entry.masks.empty() || entry.coco; });
  bool hide = false;
  for (const int id : movers) {
    if (hide || !has_masks) hidden_.insert(id), seen_[id] = 0;
    hide = !hide;
  }
  score_.movers = static_cast<int>(seen_.size());
}

void remove_movers(const std::set<int>& movers, const cv::Mat& instance, runner::SequenceFrame& frame) {
  if (frame.ids.empty() || instance.empty()) return;
  cv::Mat ids;
  frame.ids.convertTo(ids, CV_32S);
  std::map<int, long> areas;
  std::map<std::pair<int, int>, long> covered;  // by instance of the masks and mover
  for (int y = 0; y < ids.rows; ++y) {
    for (int x = 0; x < ids.cols; ++x) {
      const int id = ids.at<int>(y, x);
      if (id == 0) continue;
      ++areas[id];
      if (const int mover = instance.at<int>(y, x); movers.count(mover) > 0) ++covered[{id, mover}];
    }
  }
  for (const auto& [pair, count] : covered) {
    const int id = pair.first;
    if (2 * count < areas[id]) continue;
    frame.ids.setTo(0, ids == id);
    frame.instances.erase(
        std::remove_if(frame.instances.begin(), frame.instances.end(),
                       [id = static_cast<std::uint32_t>(id)](const dot::Instance& i) { return i.id == id; }),
        frame.instances.end());
  }
}

void HiddenMovers::add(const runner::RecordingEntry& entry, const cv::Mat& instance, const dot::Result& result) {
  if (instance.empty()) return;
  struct Count {
    long pixels = 0;
    long called_moving = 0;
  };
  std::map<int, Count> counts;
  for (int y = 0; y < instance.rows; ++y) {
    for (int x = 0; x < instance.cols; ++x) {
      Count& count = counts[instance.at<int>(y, x)];
      ++count.pixels;
      count.called_moving += result.labels(x, y) == static_cast<std::uint8_t>(dot::State::Moving);
    }
  }
  const bool frame_counts = entry.number >= scoring_.from;
  for (const auto& [id, count] : counts) {
    if (frame_counts) score_.moving += count.called_moving;
    const auto object = entry.truth.objects.find(id);
    if (object == entry.truth.objects.end() || !object->second.moving) {
      if (!frame_counts) continue;
      score_.standing += count.pixels;
      score_.false_alarm += count.called_moving;
      continue;
    }
    const auto seen = seen_.find(id);
    if (seen == seen_.end() || count.pixels < min_area || object->second.speed < scoring_.min_speed) continue;
    if (++seen->second < first_counted || !frame_counts) continue;
    score_.pixels += count.pixels;
    score_.found += count.called_moving;
  }
}

}  // namespace eval
