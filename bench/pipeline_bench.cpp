// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// A frame of the sample sequence through the whole pipeline, and its stages.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "dot/image/opencv.hpp"
#include "dot/tracker.hpp"

namespace {

struct Sample {
  dot::Intrinsics camera;
  std::vector<cv::Mat> images, depths, masks;

  Sample() {
    const std::string folder = DOT_SAMPLE_DIR;
    double fps = 10;
    std::FILE* file = std::fopen((folder + "/intrinsics.txt").c_str(), "r");
    if (!file) return;
    if (std::fscanf(file, "%lf %lf %lf %lf %d %d %lf %lf", &camera.fx, &camera.fy, &camera.cx, &camera.cy,
                    &camera.width, &camera.height, &camera.baseline, &fps) != 8)
      camera = {};
    std::fclose(file);
    for (int i = 0; camera.width > 0; ++i) {
      char name[32];
      std::snprintf(name, sizeof name, "/%06d.png", i);
      cv::Mat image = cv::imread(folder + "/rgb" + name, cv::IMREAD_UNCHANGED);
      if (image.empty()) break;
      images.push_back(image);
      depths.push_back(cv::imread(folder + "/depth" + name, cv::IMREAD_UNCHANGED));
      masks.push_back(cv::imread(folder + "/masks" + name, cv::IMREAD_UNCHANGED));
    }
  }
};

const Sample& sample() {
  static const Sample loaded;
  return loaded;
}

/// The sample from its first to its last frame; a mask every range(0) frames. Counters: milliseconds of each stage.
void BM_Track(benchmark::State& state) {
  const Sample& s = sample();
  if (s.images.size() < 2) {
    state.SkipWithError("cannot read the sample sequence");
    return;
  }
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  dot::Tracker tracker(s.camera, options);
  std::array<double, static_cast<int>(dot::Stage::Count)> stages{};
  std::size_t frames = 0;
  for (auto _ : state) {
    const std::size_t i = frames % s.images.size();
    if (i == 0) tracker.reset();
    dot::Frame frame;
    frame.id = frames;
    frame.timestamp = 0.1 * static_cast<double>(frames);
    frame.image = dot::view(s.images[i]);
    frame.depth = dot::depth_view(s.depths[i], 256);
    if (i % static_cast<std::size_t>(state.range(0)) == 0) frame.masks = dot::Masks{dot::id_view(s.masks[i]), {}};
    const dot::Result& result = tracker.track(frame);
    benchmark::DoNotOptimize(result.labels.data);
    for (std::size_t k = 0; k < stages.size(); ++k) stages[k] += result.stage_ms[k];
    ++frames;
  }
  for (std::size_t k = 0; k < stages.size(); ++k)
    state.counters[std::string(dot::to_string(static_cast<dot::Stage>(k))) + "_ms"] =
        stages[k] / static_cast<double>(frames);
}
BENCHMARK(BM_Track)->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->Iterations(96);

}  // namespace
