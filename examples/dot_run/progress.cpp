// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <string>

#include "run/percentile.hpp"
#include "sequence/entries.hpp"

namespace runner {
namespace {

int count(const dot::Result& result, dot::State state) {
  return static_cast<int>(std::count_if(result.objects.begin(), result.objects.end(),
                                        [&](const dot::ObjectResult& o) { return o.area > 0 && o.state == state; }));
}

std::string full_path(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

void print_files(const OutputPaths& output, bool revised) {
  const OutputOptions& results = output.results;
  if (!results.out.empty()) {
    std::printf("results   %s\n", full_path(results.out).c_str());
    std::printf("          labels/ instances/ %scamera.txt objects.csv %stiming.csv\n",
                results.overlay ? "overlay/ " : "", revised ? "revised.txt " : "");
  }
  if (!results.masks_out.empty())
    std::printf("masks out %s: mask_dot/ mask_all/\n", full_path(results.masks_out).c_str());
  if (!output.video.empty()) std::printf("video     %s\n", full_path(output.video).c_str());
  if (!output.player.empty()) std::printf("player    %s\n", full_path(output.player).c_str());
}

}  // namespace

Progress::Progress(int frames) : frames_(frames), terminal_(isatty(STDOUT_FILENO) == 1) {}

Progress::~Progress() {
  // An error message must not continue the line.
  if (line_open_) std::printf("\n");
  std::fflush(stdout);
}

void Progress::show(int done, const dot::Result& result, double total_ms) {
  constexpr int every = 10;
  if (!terminal_ && done % every != 0 && done != frames_) return;
  constexpr int width = 24;
  const int filled = width * done / frames_;
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  std::printf("%s[%s] %d/%d  %.1f ms  %d moving, %d static, %d not observable%s", terminal_ ? "\r" : "", bar.c_str(),
              done, frames_, total_ms, count(result, dot::State::Moving), count(result, dot::State::Static),
              count(result, dot::State::NotObservable), terminal_ ? "\033[K" : "\n");
  line_open_ = terminal_;
  std::fflush(stdout);
}

void Summary::add(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  if (!frame.ids.empty()) ++segmented_;
  total_ms_.push_back(total_ms);
  if (result.camera.status == dot::CameraStatus::Lost || result.camera.status == dot::CameraStatus::TooLittleDepth)
    ++camera_lost_;
  revised_ += static_cast<int>(result.revised.size);
  disparity_bias_px_ = result.disparity_bias_px;
  if (const dot::Diagnosis& diagnosis = result.diagnosis; diagnosis.reason != dot::Suspicion::None) {
    ++suspicions_[diagnosis.reason];
    figures_[diagnosis.reason] = diagnosis.figure;
  }
  for (const dot::ObjectResult& object : result.objects)
    if (object.area > 0) last_decided_[object.id] = object.last_decided;
}

void Summary::print_masks() const {
  const std::filesystem::path folder = source_.folder / source_.mask_dir;
  std::printf("masks     ");
  if (segmented_ > 0)
    std::printf("in %d of %zu frames\n", segmented_, total_ms_.size());
  else if (!source_.masks)
    std::printf("by the network\n");
  else if (!is_there(folder))
    std::printf("none: there is no folder %s; without masks objects are found with --discover alone\n", folder.c_str());
  else
    std::printf("none in these frames: of %s only those of frames 0, %d, %d, ... were wanted\n", folder.c_str(),
                source_.mask_every, 2 * source_.mask_every);
}

std::vector<double> Summary::steady_ms() const {
  // The first frame takes the buffers and has nothing to compare with.
  return {total_ms_.begin() + (total_ms_.size() > 1 ? 1 : 0), total_ms_.end()};
}

void Summary::print_suspicions() const {
  // The check is to look at the same parts.
  const runner::SequenceOptions usual;
  std::string parts;
  if (source_.depth_dir != usual.depth_dir) parts += " --depth-dir " + source_.depth_dir;
  if (source_.mask_dir != usual.mask_dir) parts += " --mask-dir " + source_.mask_dir;
  if (source_.stereo) parts += " --stereo";
  for (const auto& [suspicion, frames] : suspicions_) {
    std::printf("input     %s (%.3g) in %d frames: ", dot::to_string(suspicion), figures_.at(suspicion), frames);
    if (suspicion == dot::Suspicion::RollingShutter || suspicion >= dot::Suspicion::UnsteadyScale)
      std::printf("see docs/failures.md\n");
    else
      std::printf("look at it with dot_run %s%s --check\n", source_.folder.c_str(), parts.c_str());
  }
}

dataset::Figures Summary::figures() const {
  const auto count_objects = [&](dot::State state) {
    return static_cast<int>(
        std::count_if(last_decided_.begin(), last_decided_.end(), [&](auto& entry) { return entry.second == state; }));
  };
  dataset::Figures f;
  f.frames = static_cast<int>(total_ms_.size());
  f.moving = count_objects(dot::State::Moving);
  f.standing = count_objects(dot::State::Static);
  f.undecided = static_cast<int>(last_decided_.size()) - f.moving - f.standing;
  f.camera_lost = camera_lost_;
  const std::vector<double> ms = steady_ms();
  if (!ms.empty()) f.ms_per_frame = std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size());
  return f;
}

void Summary::print(const OutputPaths& output, const std::string& remarks) const {
  const dataset::Figures f = figures();
  std::printf("frames    %d", f.frames);
  if (f.camera_lost > 0) std::printf(", camera motion not found in %d", f.camera_lost);
  std::printf("\n");
  if (revised_ > 0)
    std::printf("camera    %d motion%s of the camera %s revised: a later frame showed that %s wrong\n", revised_,
                revised_ > 1 ? "s" : "", revised_ > 1 ? "were" : "was", revised_ > 1 ? "they were" : "it was");
  print_masks();
  std::printf("%s", remarks.c_str());
  std::printf("objects   %zu: %d moving, %d static, %d never decided (as last decided)\n", last_decided_.size(),
              f.moving, f.standing, f.undecided);
  if (disparity_bias_px_ >= 0.05)
    std::printf("depth     disparities off by %.2f px (RMS over the image, as learnt); corrected\n",
                disparity_bias_px_);
  print_suspicions();
  if (f.frames > 1) {
    const std::vector<double> ms = steady_ms();
    std::printf(
        "time      %.1f ms a frame, median %.1f, p99 %.1f, at most %.1f (tracking alone, without the first frame)\n",
        f.ms_per_frame, percentile(ms, 50), percentile(ms, 99), percentile(ms, 100));
  } else
    std::printf("time      %.1f ms (first frame)\n", f.ms_per_frame);

  print_files(output, revised_ > 0);
}

}  // namespace runner
