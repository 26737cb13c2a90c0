// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "overlay_video.hpp"

#include <algorithm>

#include "run/overlay.hpp"
#include "run/percentile.hpp"

namespace player {
namespace {

double frame_rate(const runner::Recording& recording) {
  constexpr double usual = 10;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < recording.entries.size(); ++i)
    intervals.push_back(recording.entries[i].timestamp - recording.entries[i - 1].timestamp);
  return intervals.empty() ? usual : 1 / runner::percentile(intervals, 50);
}

}  // namespace

OverlayVideo::OverlayVideo(const std::filesystem::path& path, const runner::Recording& recording,
                           std::optional<double> fps)
    : file_(path, std::clamp(fps ? *fps : frame_rate(recording), 1.0, 240.0)) {
  for (const runner::RecordingEntry& entry : recording.entries) numbers_.push_back(entry.number);
}

void OverlayVideo::add(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms) {
  cv::Mat picture = runner::draw_overlay(frame, result, total_ms);
  for (; next_ < numbers_.size() && numbers_[next_] < frame.number; ++next_)
    file_.add(picture_.empty() ? picture : picture_);
  file_.add(picture);
  ++next_;
  picture_ = picture;
}

}  // namespace player
