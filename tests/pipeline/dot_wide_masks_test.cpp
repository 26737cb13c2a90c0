// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Masks as a detector gives them: boxes that overlap, each with parts of what is behind and before its object.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::Instance;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

constexpr std::uint32_t kMover = 3;

/// Cars at the roadside, and one that drives past before them. The camera drives slowly.
Film<> street() {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.degradation.noise = 1;
  film.degradation.depth_noise = 1e-4;
  film.add(1, straight({-3.2, 1.3, 10}));
  film.add(2, straight({2.8, 1.3, 11}));
  film.add(kMover, straight({-1.2, 1.3, 6}, {1.5, 0, 1}));
  return film;
}

/// The box of each id, 255 inside.
struct Boxes {
  std::vector<std::vector<std::uint8_t>> pixels;
  std::vector<Instance> instances;

  explicit Boxes(const dot::Image<std::uint32_t>& ids) {
    struct Corners {
      int left = 1 << 20, top = 1 << 20, right = 0, bottom = 0;
    };
    std::map<std::uint32_t, Corners> corners;
    for (int y = 0; y < ids.height(); ++y)
      for (int x = 0; x < ids.width(); ++x) {
        if (ids(x, y) == 0) continue;
        Corners& c = corners[ids(x, y)];
        c = {std::min(c.left, x), std::min(c.top, y), std::max(c.right, x + 1), std::max(c.bottom, y + 1)};
      }
    for (const auto& [id, c] : corners) {
      // A quarter of the box's size wider: detectors are not exact.
      const int wider = (c.right - c.left) / 8, width = c.right - c.left + 2 * wider, height = c.bottom - c.top;
      pixels.emplace_back(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), std::uint8_t{255});
      Instance instance;
      instance.id = id;
      instance.x = c.left - wider;
      instance.y = c.top;
      instance.mask = {pixels.back().data(), width, height, width, dot::PixelFormat::Grey8};
      instances.push_back(instance);
    }
  }
};

TEST(WideMasks, BoxesThatOverlapKeepTheirObjects) {
  Film<> film = street();
  Tracker tracker(small_camera(), Options{});
  int shown = 0, answered = 0;
  for (int i = 0; i < 16; ++i) {
    dot::Frame frame = film.advance();
    const Boxes boxes(film.seen().ids);
    frame.masks->ids = {};
    frame.masks->instances = {boxes.instances.data(), boxes.instances.size()};
    const Result& result = tracker.track(frame);
    std::map<std::uint32_t, State> state;
    std::map<std::uint32_t, std::uint32_t> instance;
    for (const auto& o : result.objects) state[o.instance_id] = o.state, instance[o.id] = o.instance_id;
    for (const std::uint32_t parked : {1u, 2u}) EXPECT_NE(state[parked], State::Moving) << parked << " in " << i;
    if (i < 6) continue;
    EXPECT_EQ(state[kMover], State::Moving) << i;
    for (int y = 0; y < result.ids.height; ++y)
      for (int x = 0; x < result.ids.width; ++x) {
        const std::uint32_t id = result.ids.row(y)[x];
        const bool answer = id != 0 && instance[id] == kMover, truth = film.truth().ids(x, y) == kMover;
        answered += answer;
        shown += answer && truth;
      }
  }
  EXPECT_GT(shown, 0.85 * answered) << "a fifth of its box is beside it";
}

TEST(WideMasks, AreNamed) {
  Film<> film = street();
  Tracker tracker(small_camera(), Options{});
  for (int i = 0; i < 24; ++i) {
    dot::Frame frame = film.advance();
    const Boxes boxes(film.seen().ids);
    frame.masks->ids = {};
    frame.masks->instances = {boxes.instances.data(), boxes.instances.size()};
    const Result& result = tracker.track(frame);
    EXPECT_TRUE(i < 20 || result.diagnosis.reason == dot::Suspicion::WideMasks) << i;
  }
  Film<> other = street();
  tracker.reset();
  for (int i = 0; i < 24; ++i) {
    const Result& result = other.next(tracker);
    EXPECT_EQ(result.diagnosis.reason, dot::Suspicion::None) << i << ": these masks fit";
  }
}

}  // namespace
