// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Masks as a detector gives them: boxes that overlap, each with parts of what is behind and before its object.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "dot/mask/mask.hpp"
#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::Instance;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

constexpr std::uint32_t kParked = 1, kMover = 3;

/// The boxes of a frame's objects, an eighth wider on each side: detectors are not exact.
struct Boxes {
  std::vector<std::vector<std::uint8_t>> pixels;
  std::vector<Instance> instances;

  explicit Boxes(const dot::Image<std::uint32_t>& ids) {
    for (const std::uint32_t id : {kParked, kMover}) {
      dot::Mask mask;
      dot::crop_ids<std::uint32_t>(ids.view(), id, {0, 0, ids.width(), ids.height()}, mask);
      if (mask.empty()) continue;
      const int margin = mask.width() / 8, width = mask.width() + 2 * margin, height = mask.height();
      pixels.emplace_back(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), std::uint8_t{255});
      Instance instance;
      instance.id = id;
      instance.x = mask.x - margin;
      instance.y = mask.y;
      instance.mask = {pixels.back().data(), width, height, width, dot::PixelFormat::Grey8};
      instances.push_back(instance);
    }
  }
};

// A car begins to pass before a parked one. Its box covers a part of what is still seen of the parked one.
TEST(OverlappingBoxes, LeaveEachObjectItsPixels) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.degradation.noise = 1;
  film.degradation.depth_noise = 1e-4;
  film.add(kParked, straight({1.2, 1.3, 10}));
  film.add(kMover, straight({-2.0, 1.3, 6}, {1.5, 0, 1}));
  Tracker tracker(small_camera(), Options{});
  int hidden = 0, seen = 0, moving = 0, of_mover = 0, shown = 0, around = 0;
  for (int i = 0; i < 12; ++i) {
    dot::Frame frame = film.advance();
    const Boxes boxes(film.seen().ids);
    frame.masks->ids = {};
    frame.masks->instances = {boxes.instances.data(), boxes.instances.size()};
    const Result& result = tracker.track(frame);
    std::map<std::uint32_t, State> state;
    for (const dot::ObjectResult& o : result.objects) state[o.instance_id] = o.state;
    EXPECT_NE(state[kParked], State::Moving) << i;
    if (i < 6) continue;
    EXPECT_EQ(state[kMover], State::Moving) << i;
    const Instance& box = boxes.instances.back();
    for (int y = 0; y < result.labels.height; ++y)
      for (int x = 0; x < result.labels.width; ++x) {
        const bool called_moving = result.labels.row(y)[x] == static_cast<std::uint8_t>(State::Moving);
        const std::uint32_t id = film.truth().ids(x, y);
        of_mover += id == kMover, shown += id == kMover && called_moving, around += id == 0 && called_moving;
        if (id != kParked) continue;
        ++seen;
        hidden += x >= box.x && x < box.x + box.mask.width && y >= box.y && y < box.y + box.mask.height;
        moving += called_moving;
      }
  }
  ASSERT_GT(hidden, 0.1 * seen) << "the mover's box shows the parked car";
  EXPECT_LT(moving, 0.2 * hidden);
  EXPECT_GT(shown, 0.95 * of_mover);
  // A fifth of the box is what is around the mover. The road beside it is as near, and stays.
  EXPECT_LT(around, 0.16 * of_mover);
}

}  // namespace
