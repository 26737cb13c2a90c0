// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "dot/tracker.hpp"
#include "fuzz/scene.hpp"
#include "support/host_pool.hpp"

/// @file
/// Trackers at work at the same time, each on several threads. A program of its own, so that the thread sanitizer has
/// little to build.

namespace {

constexpr int kWidth = 96, kHeight = 64, kFrames = 12;
constexpr double kFocal = 95;

/// A film's frames; each is a view of a picture, hence kept together.
struct Film {
  std::array<std::vector<std::uint8_t>, kFrames> grey, ids;
  std::array<fuzz::Picture, kFrames> pictures;

  /// @param speed of the plate that no mask shows, m/s
  explicit Film(double speed) {
    fuzz::Scene scene(fuzz::Input(nullptr, 0), kFocal, kWidth, kHeight);
    scene.plates[1].velocity_x = speed;
    for (std::size_t i = 0; i < kFrames; ++i) {
      scene.advance(0.1);
      pictures[i] = scene.render();
      grey[i].assign(pictures[i].grey.begin(), pictures[i].grey.end());
      for (const std::uint8_t id : pictures[i].ids) ids[i].push_back(id == 2 ? 0 : id);
    }
  }
  dot::Frame frame(std::size_t i) const {
    dot::Frame out;
    out.id = i;
    out.timestamp = 0.1 * static_cast<double>(i);
    out.image = {grey[i].data(), kWidth, kHeight, kWidth, dot::PixelFormat::Grey8, 1};
    out.depth = {pictures[i].depth.data(), kWidth, kHeight, 4 * kWidth, dot::PixelFormat::DepthF32, 1};
    return out;
  }
  dot::Masks masks(std::size_t i) const {
    dot::Masks out;
    out.ids = {ids[i].data(), kWidth, kHeight, kWidth, dot::PixelFormat::Id8, 1};
    return out;
  }
};

struct Told {
  std::string text;
  bool discovered = false;
  std::size_t objects = 0;
};

/// What a tracker says of a film whose masks come with the frame, a frame late, or not at all.
Told watch(const Film& film, int threads, const dot::ThreadPool& pool) {
  dot::Intrinsics camera;
  camera.fx = camera.fy = kFocal;
  camera.cx = 0.5 * kWidth;
  camera.cy = 0.5 * kHeight;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.baseline = 0.5;
  dot::Options options;
  options.threads = threads;
  options.discover_unknown = true;
  options.depth_noise.source = dot::DepthSource::Stereo;
  options.selection.background_points = 500;
  dot::Tracker tracker(camera, options);
  tracker.set_pool(pool);
  Told told;
  for (std::size_t i = 0; i < kFrames; ++i) {
    dot::Frame frame = film.frame(i);
    if (i < 2) frame.masks = film.masks(i);
    const dot::Result& result = tracker.track(frame);
    for (const dot::ObjectResult& o : result.objects) {
      told.text += std::to_string(o.id) + " " + to_string(o.state) + " " + to_string(o.reason) + " " +
                   std::to_string(o.p_moving) + " " + std::to_string(o.area) + " " + std::to_string(o.speed) + "\n";
      told.discovered = told.discovered || o.discovered;
    }
    told.objects = result.objects.size;
    if (i % 3 == 0 && i > 2) tracker.submit_masks(i - 1, film.masks(i - 1));
  }
  return told;
}

void expect_the_same_together_as_alone(const dot::ThreadPool& pool) {
  const std::array<Film, 2> films{Film(4), Film(-3)};
  std::array<Told, 2> alone, together;
  for (std::size_t i = 0; i < 2; ++i) alone[i] = watch(films[i], 1, {});
  std::vector<std::thread> hosts;
  for (std::size_t i = 0; i < 2; ++i) hosts.emplace_back([&, i] { together[i] = watch(films[i], 4, pool); });
  for (std::thread& host : hosts) host.join();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(alone[i].text, together[i].text);
    EXPECT_GE(alone[i].objects, 2u);
  }
  EXPECT_TRUE(alone[0].discovered) << "nothing was found without a mask:\n" << alone[0].text;
  EXPECT_NE(alone[0].text, alone[1].text);
}

TEST(TrackersAtOnce, OnThreadsOfTheirHostsSeeWhatEachSeesAlone) {
  expect_the_same_together_as_alone(dot::test::host_pool);
}
TEST(TrackersAtOnce, OnOpenCvsThreadsSeeWhatEachSeesAlone) { expect_the_same_together_as_alone({}); }

}  // namespace
