// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run_writer.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "run/overlay.hpp"

namespace runner {
namespace {

/// Frames a second of a recording, by the median of its intervals.
double frame_rate(const Recording& recording) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < recording.entries.size(); ++i)
    intervals.push_back(recording.entries[i].timestamp - recording.entries[i - 1].timestamp);
  if (intervals.empty()) return 10;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return std::clamp(1 / *middle, 1.0, 240.0);
}

std::string name_of(const std::filesystem::path& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

RunWriter::RunWriter(const Outputs& outputs, const SequenceOptions& source, const Sequence& sequence,
                     const dot::Options& options) {
  if (!outputs.results.out.empty()) results_.emplace(outputs.results, source.folder);
  if (!outputs.video.empty()) video_.emplace(outputs.video, frame_rate(sequence.recording()));
  if (!outputs.player.empty())
    player_.emplace(outputs.player, player::RunInfo{name_of(source.folder), sequence.intrinsics(), options});
}

void RunWriter::write(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  if (results_) results_->write(frame, result, total_ms);
  if (video_) video_->add(draw_overlay(frame, result, total_ms));
  if (player_) player_->add(frame, result, total_ms);
}

void RunWriter::finish() {
  if (player_) player_->finish();
  if (video_) video_->finish();
  if (results_) results_->finish();
}

}  // namespace runner
