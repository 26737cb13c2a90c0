// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// The whole pipeline by number of objects, by resolution and by the area that objects cover: boxes before a wall, every
// other one moving, masks in every frame. The first two frames of each film are not counted.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "dot/tracker.hpp"
#include "measure.hpp"
#include "room.hpp"

namespace {

using namespace dot::bench;
using dot::Vector3;

constexpr int kColumns = 8, kRows = 5, kFrames = 6;

dot::test::Scene wall(double shortest) {
  dot::test::Scene scene;
  dot::test::Body wall;
  wall.quads.push_back(
      {Vector3<double>(0, 0, 6), Vector3<double>(8, 0, 0), Vector3<double>(0, 6, 0), {1, shortest, 1.2}});
  scene.bodies.push_back(wall);
  return scene;
}

void add_box(dot::test::Scene& scene, int i, const Vector3<double>& half, const Vector3<double>& at, double shortest) {
  dot::test::Body box =
      dot::test::box(static_cast<unsigned>(i + 1), half, 100 + 10 * static_cast<unsigned>(i), shortest, 1.2);
  box.T_world_body.t = at;
  scene.bodies.push_back(box);
}

/// The first `count` places of a grid, in an order that spreads them.
dot::test::Scene scene_of(int count, double time, double shortest) {
  dot::test::Scene scene = wall(shortest);
  for (int i = 0; i < count; ++i) {
    const int place = i * 17 % (kColumns * kRows), column = place % kColumns, row = place / kColumns;
    add_box(scene, i, Vector3<double>::Constant(0.16),
            {0.55 * (column - 3.5) + (i % 2 ? 1.0 * time - 0.25 : 0), 0.65 * (row - 2), 4.2}, shortest);
  }
  return scene;
}

/// Eight boxes, four beside each other, whose fronts cover this share of the image. Every other one recedes.
dot::test::Scene covered_scene(double share, double time, const dot::Pinhole& camera, double shortest) {
  constexpr double kDepth = 3;
  dot::test::Scene scene = wall(shortest);
  const double width = camera.width() * kDepth / camera.intrinsics().fx / 4;
  const double height = camera.height() * kDepth / camera.intrinsics().fy / 2, side = std::sqrt(share) / 2;
  for (int i = 0; i < 8; ++i) {
    const int column = i % 4, row = i / 4;
    add_box(scene, i, {side * width, side * height, 0.1},
            {(column - 1.5) * width, (row - 0.5) * height, kDepth + 0.1 + (i % 2 ? 0.5 * time : 0)}, shortest);
  }
  return scene;
}

/// Half a second of a camera that goes ahead, `scene(time)` before it.
template <typename SceneAt>
std::vector<dot::test::Rendering> film_of(const dot::Pinhole& camera, double speed, SceneAt&& scene) {
  std::vector<dot::test::Rendering> film;
  for (int i = 0; i < kFrames; ++i) {
    dot::test::Degradation sensor;
    sensor.noise = 2, sensor.depth_noise = 0.0008, sensor.seed = static_cast<unsigned>(i + 1);
    const double time = 0.1 * i;
    const dot::SE3d T_world_camera = dot::SE3d::translation(Vector3<double>(0.2 * time, 0, speed * time));
    film.push_back(degraded(scene(time).render(camera, T_world_camera), sensor));
  }
  return film;
}

/// One iteration is one film.
void track_film(benchmark::State& state, const dot::Pinhole& camera, const std::vector<dot::test::Rendering>& film) {
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Rgbd;
  dot::Tracker tracker(camera.intrinsics(), options);
  std::vector<double> stages(static_cast<std::size_t>(dot::Stage::Count));
  double frames = 0, objects = 0, covered = 0;
  for (auto _ : state) {
    tracker.reset();
    double ms = 0;
    for (std::size_t i = 0; i < film.size(); ++i) {
      dot::Frame frame;
      frame.id = i, frame.timestamp = 0.1 * static_cast<double>(i);
      frame.image = film[i].image_ref(), frame.depth = film[i].depth_ref();
      frame.masks = dot::Masks{film[i].ids_ref(), {}};
      const dot::Result* result = nullptr;
      const double one = milliseconds([&] { result = &tracker.track(frame); });
      if (i < 2) continue;
      ms += one, ++frames, objects += static_cast<double>(result->objects.size);
      for (const dot::ObjectResult& object : result->objects) covered += object.area;
      const double on_clock = std::accumulate(result->stage_ms.begin(), result->stage_ms.end(), 0.0);
      for (std::size_t k = 0; k < stages.size(); ++k) stages[k] += result->stage_ms[k] * one / on_clock;
    }
    state.SetIterationTime(1e-3 * ms / (kFrames - 2));  // of one frame
  }
  using benchmark::Counter;
  const double pixels = 1.0 * camera.width() * camera.height();
  state.counters["objects"] = objects / frames;
  state.counters["covered"] = covered / frames / pixels;
  state.counters["pixels"] = Counter(pixels, Counter::kIsIterationInvariantRate);
  for (std::size_t k = 0; k < stages.size(); ++k)
    state.counters[std::string(dot::to_string(static_cast<dot::Stage>(k))) + "_ms"] = stages[k] / frames;
}

/// range(0): objects, range(1): width.
void BM_Scene(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0)), width = static_cast<int>(state.range(1));
  const dot::Pinhole camera = camera_of(width, width > 1280 ? width * 9 / 16 : width * 3 / 4);
  const double shortest = 0.06 * 520 / camera.intrinsics().fx;
  track_film(state, camera, film_of(camera, 0.5, [&](double time) { return scene_of(count, time, shortest); }));
}

/// range(0): percent of a 1242x375 image that eight objects cover.
void BM_CoveredArea(benchmark::State& state) {
  const dot::Pinhole camera = camera_of(1242, 375);
  const double share = 0.01 * static_cast<double>(state.range(0)), shortest = 0.06 * 520 / camera.intrinsics().fx;
  track_film(state, camera,
             film_of(camera, 0.1, [&](double time) { return covered_scene(share, time, camera, shortest); }));
}
BENCHMARK(BM_CoveredArea)
    ->ArgsProduct({{1, 5, 20, 40, 60, 80}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(9);

BENCHMARK(BM_Scene)
    ->ArgsProduct({{0, 1, 2, 5, 10, 20, 40}, {640}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(5);
BENCHMARK(BM_Scene)
    ->ArgsProduct({{5}, {320, 1280, 1920, 3840}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(3);

/// range(0): instances on a grid before a standing wall at 1280x720, range(1): 1 where they jump aside by half a step
/// in every frame, so that none belongs to any track. One iteration is one frame; the first two are not counted.
void BM_ManyInstances(benchmark::State& state) {
  constexpr int width = 1280, height = 720, columns = 40;
  const int count = static_cast<int>(state.range(0)), rows = (count + columns - 1) / columns;
  const int step_x = width / columns, step_y = height / std::max(rows, 1);
  dot::test::Random random(1);
  dot::Image<std::uint8_t> grey(width, height);
  dot::Image<float> depth(width, height);
  depth.fill(5);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grey(x, y) = static_cast<std::uint8_t>(random.uniform(0, 256));
  dot::Image<std::uint32_t> ids[2] = {{width, height}, {width, height}};
  for (int i = 0; i < count; ++i)
    for (int y = 0; y < step_y / 2; ++y)
      for (int x = 0; x < step_x / 2; ++x)
        for (int k = 0; k < 2; ++k)
          ids[k](i % columns * step_x + x + k * (step_x / 2), i / columns * step_y + y) =
              static_cast<std::uint32_t>(i + 1);
  dot::Tracker tracker({600, 600, width / 2.0, height / 2.0, width, height, 0});
  std::uint64_t index = 0;
  std::size_t tracks = 0;
  const auto next = [&] {
    dot::Frame frame;
    frame.id = index, frame.timestamp = 0.1 * static_cast<double>(index);
    frame.image = {grey.row(0), width, height, width, dot::PixelFormat::Grey8};
    frame.depth = {depth.row(0), width, height, 4 * width, dot::PixelFormat::DepthF32};
    const dot::Image<std::uint32_t>& seen = ids[state.range(1) ? index % 2 : 0];
    frame.masks = dot::Masks{{seen.row(0), width, height, 4 * width, dot::PixelFormat::Id32}, {}};
    tracks = tracker.track(frame).objects.size;
    ++index;
  };
  next(), next();
  for (auto _ : state) next();
  state.counters["tracks"] = static_cast<double>(tracks);
}
BENCHMARK(BM_ManyInstances)->ArgsProduct({{100, 200, 1000}, {0, 1}})->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
