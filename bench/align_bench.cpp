// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// A frame to frame alignment and what precedes it, by resolution, points and source of gradients: a textured room.
#include <benchmark/benchmark.h>

#include <map>

#include "dot/image/depth_pyramid.hpp"
#include "dot/kernel/dispatch.hpp"
#include "room.hpp"
#include "whole_alignment.hpp"

namespace {

using benchmark::Counter;
using namespace dot::bench;

/// Rendered once for each width; 4:3, but for those wider than 1280 16:9.
const Pair& pair_of(int width) {
  static std::map<int, Pair> pairs;
  const int height = width > 1280 ? width * 9 / 16 : width * 3 / 4;
  if (!pairs.count(width)) pairs.emplace(width, room_pair(3, camera_of(width, height)));
  return pairs.at(width);
}

WholeAlignment aligner_of(const Pair& pair, int points) {
  dot::DepthNoiseSettings prior;
  prior.source = dot::DepthSource::Rgbd;
  const dot::Pinhole camera = camera_of(pair.reference.grey.width(), pair.reference.grey.height());
  WholeAlignment ours(camera, dot::DepthNoise(prior, camera.intrinsics()));
  ours.selection.background_points = points;
  ours.prepare(pair.reference.image_ref(), pair.reference.depth_ref());
  ours.prepare(pair.current.image_ref(), pair.current.depth_ref());
  return ours;
}

void pixels(benchmark::State& state, const Pair& pair) {
  const double n = 1.0 * pair.reference.grey.width() * pair.reference.grey.height();
  state.counters["pixels"] = Counter(n, Counter::kIsIterationInvariantRate);
}

void BM_Pyramid(benchmark::State& state) {
  const Pair& pair = pair_of(static_cast<int>(state.range(0)));
  dot::Pyramid pyramid;
  const int levels = dot::pyramid_levels(pair.reference.grey.width(), pair.reference.grey.height(), 5);
  for (auto _ : state) {
    pyramid.build(pair.reference.grey.view(), levels, *dot::find_kernels());
    benchmark::ClobberMemory();
  }
  pixels(state, pair);
}

void build_depth(benchmark::State& state, int max_levels) {
  const Pair& pair = pair_of(static_cast<int>(state.range(0)));
  const dot::ImageRef depth = pair.reference.depth_ref();
  const int levels = dot::pyramid_levels(depth.width, depth.height, max_levels);
  const dot::kernel::Kernels& kernels = *dot::find_kernels();
  dot::DepthPyramid pyramid;
  for (auto _ : state) {
    pyramid.build(depth.width, depth.height, dot::InverseDepthRows(depth, 400, kernels), levels, kernels);
    benchmark::DoNotOptimize(pyramid.levels[0].row(0));
    benchmark::ClobberMemory();
  }
  pixels(state, pair);
}
void BM_InverseDepth(benchmark::State& state) { build_depth(state, 1); }
/// The inverse depth and the levels above it.
void BM_DepthPyramid(benchmark::State& state) { build_depth(state, 5); }

/// range(1): budget of points.
void BM_Select(benchmark::State& state) {
  const Pair& pair = pair_of(static_cast<int>(state.range(0)));
  WholeAlignment ours = aligner_of(pair, static_cast<int>(state.range(1)));
  for (auto _ : state) {
    ours.select();
    benchmark::ClobberMemory();
  }
  pixels(state, pair);
  state.counters["points"] = Counter(ours.points().size(), Counter::kIsIterationInvariantRate);
}

/// From the identity through all levels, with outliers and statistics. range(2): GradientSource.
void BM_Align(benchmark::State& state) {
  const Pair& pair = pair_of(static_cast<int>(state.range(0)));
  WholeAlignment ours = aligner_of(pair, static_cast<int>(state.range(1)));
  ours.aligner.settings.gradient = static_cast<dot::GradientSource>(state.range(2));
  double iterations = 0;
  for (auto _ : state) iterations += ours.align().iterations;
  constexpr const char* names[] = {"image", "reference", "mean"};
  state.SetLabel(names[state.range(2)]);
  const double points = ours.points().size();
  state.counters["point_iterations"] = Counter(points * iterations, Counter::kIsRate);
  state.counters["iterations"] = Counter(iterations, Counter::kAvgIterations);
}

const std::vector<std::int64_t> widths{320, 640, 1280, 1920, 3840};

BENCHMARK(BM_Pyramid)->ArgsProduct({widths})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_InverseDepth)->ArgsProduct({widths})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DepthPyramid)->ArgsProduct({widths})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Select)->ArgsProduct({widths, {3000}})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Select)->ArgsProduct({{640}, {300, 1000, 10000}})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Align)->ArgsProduct({{640}, {300, 1000, 3000, 10000}, {0, 1, 2}})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Align)->ArgsProduct({{320, 1280, 1920, 3840}, {3000}, {0}})->Unit(benchmark::kMicrosecond);

}  // namespace
