// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// The whole pipeline over a recorded sequence, with the masks of every frame, and in turn one call of OpenCV's
// RgbdOdometry for the same pair of frames; one thread. Means over the frames after the first. The last column is the
// ratio of the time up to the labels (`label` without `prepare`).
//
//     bench_peer_sequence [--passes N] SEQUENCE...
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "dot/kernel/dispatch.hpp"
#include "dot/tracker.hpp"
#include "measure.hpp"
#include "run/run_options.hpp"
#include "street.hpp"

namespace {

using namespace dot::bench;

constexpr std::size_t kStages = static_cast<std::size_t>(dot::Stage::Count);

/// Of one sequence: the mean of each pass.
struct Times {
  std::vector<double> track, peer;
  std::array<std::vector<double>, kStages> stages;
  double objects = 0;
};

Times measure(const std::string& folder, int passes) {
  runner::RunOptions run;
  run.sequence.folder = folder;
  runner::Sequence sequence(run.sequence);
  dot::Tracker tracker(sequence.intrinsics(), runner::tracker_options(run, sequence.depth_source()));
  Peer peer(sequence.intrinsics(), street_limits());
  Times times;
  for (int pass = 0; pass < passes; ++pass) {
    tracker.reset();
    std::optional<PeerImages> before;
    double track = 0, peer_time = 0, objects = 0;
    std::array<double, kStages> stages{};
    for (int i = 0; i < sequence.size(); ++i) {
      const runner::SequenceFrame frame = sequence.read(i);
      const dot::Frame input = frame.frame();
      const PeerImages now(frame);
      const dot::Result* result = nullptr;
      const double ms = milliseconds([&] { result = &tracker.track(input); });
      if (before) {
        track += ms;
        // Stages are measured on the clock: their shares hold, their sum may be more than the processor's time.
        const double on_clock = std::accumulate(result->stage_ms.begin(), result->stage_ms.end(), 0.0);
        for (std::size_t k = 0; k < kStages; ++k) stages[k] += result->stage_ms[k] * ms / on_clock;
        objects += static_cast<double>(result->objects.size);
        dot::SE3d T;
        peer_time += milliseconds([&] { peer.align(before->grey, before->depth, {}, now.grey, now.depth, {}, T); });
      }
      before = now;
    }
    const double frames = sequence.size() - 1;
    times.track.push_back(track / frames), times.peer.push_back(peer_time / frames);
    for (std::size_t k = 0; k < kStages; ++k) times.stages[k].push_back(stages[k] / frames);
    times.objects = objects / frames;
  }
  return times;
}

void run(const std::vector<std::string>& folders, int passes) {
  std::printf("milliseconds a frame, median of %d passes, one thread, kernels: %s\n\n%-16s %7s", passes,
              dot::find_kernels()->name, "", "objects");
  for (std::size_t k = 0; k < kStages; ++k) std::printf(" %7s", dot::to_string(static_cast<dot::Stage>(k)));
  std::printf(" %7s %7s %7s %7s\n", "track", "peer", "ratio", "labels");
  for (const std::string& folder : folders) {
    const Times t = measure(folder, passes);
    std::printf("%-16s %7.1f", std::filesystem::path(folder).lexically_normal().filename().c_str(), t.objects);
    for (const auto& stage : t.stages) std::printf(" %7.3f", median(stage));
    const double points = median(t.stages[static_cast<std::size_t>(dot::Stage::Points)]);
    std::printf(" %7.3f %7.3f %7.3f %7.3f\n", median(t.track), median(t.peer), median(t.track) / median(t.peer),
                (median(t.track) - points) / median(t.peer));
  }
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  int passes = 5;
  std::vector<std::string> folders;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--passes") && i + 1 < argc)
      passes = std::atoi(argv[++i]);
    else
      folders.push_back(argv[i]);
  }
  try {
    run(folders, passes);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_peer_sequence: %s\n", error.what());
    return 1;
  }
}
