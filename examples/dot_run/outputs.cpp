// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "outputs.hpp"

#include <cstdio>
#include <filesystem>

namespace runner {
namespace {

std::string name_of(const std::filesystem::path& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

Outputs::Outputs(const Arguments& arguments, const Sequence& sequence, const dot::Options& options,
                 const std::vector<std::string>& class_names)
    : paths_(arguments.output), summary_(arguments.run.sequence) {
  const std::filesystem::path& folder = arguments.run.sequence.folder;
  if (!paths_.results.out.empty()) results_.emplace(paths_.results, folder);
  if (!paths_.video.empty()) video_.emplace(paths_.video, sequence.recording(), arguments.fps);
  if (!paths_.player.empty())
    player_.emplace(paths_.player, player::RunInfo{name_of(folder), sequence.intrinsics(), options, class_names});
  progress_.emplace(sequence.size());
}

void Outputs::add(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  if (results_) results_->write(frame, result, total_ms);
  if (video_) video_->add(frame, result, total_ms);
  if (player_) player_->add(frame, result, total_ms);
  summary_.add(frame, result, total_ms);
  progress_->show(++done_, result, total_ms);
}

dataset::Figures Outputs::finish(bool complete, const std::string& remarks) {
  progress_.reset();
  OutputPaths written = paths_;
  if (complete) {
    if (player_) player_->finish();
    if (video_) video_->finish();
    if (results_) results_->finish();
  } else {
    written.video.clear();
    written.player.clear();
  }
  if (done_ > 0) summary_.print(written, remarks);
  if (!complete) std::fprintf(stderr, "dot_run: interrupted after %d frames\n", done_);
  return summary_.figures();
}

}  // namespace runner
