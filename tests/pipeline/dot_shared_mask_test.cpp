// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// One mask about two objects that touch in the image, as a network gives it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/mask/mask.hpp"
#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::Masks;
using dot::ObjectResult;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

constexpr std::uint32_t kParked = 1, kMover = 3;

/// A car crosses behind a parked one, both in one mask from a frame on.
Film<> two_in_one_mask(int from) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, 0.5});
  film.degradation.noise = 1;
  film.degradation.depth_noise = 1e-4;
  film.add(kParked, straight({-0.9, 1.3, 5}));
  film.add(kMover, straight({0.2, 1.3, 12}, {4, 0, 0}));
  film.spoil = [from](int index, Rendering& seen) {
    if (index < from) return;
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == kMover) seen.ids(x, y) = kParked;
  };
  return film;
}

TEST(SharedMask, IsDividedWhenTheMotionsAreKnown) {
  Film<> film = two_in_one_mask(0);
  Tracker tracker(small_camera(), Options{});
  int divided = 0;
  std::uint32_t parked = 0, mover = 0;
  for (int i = 0; i < 14; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* near = object_on(result, film.truth().ids, kParked);
    const ObjectResult* far = object_on(result, film.truth().ids, kMover);
    ASSERT_TRUE(near && far) << i;
    if (near == far) {
      EXPECT_EQ(divided, 0) << "frame " << i;
      EXPECT_EQ(result.objects.size, 1u) << "frame " << i << ": its parts are no objects yet";
      continue;
    }
    ++divided;
    if (divided == 1) parked = near->id, mover = far->id;
    EXPECT_EQ(near->id, parked);
    EXPECT_EQ(far->id, mover);
    EXPECT_EQ(near->instance_id, far->instance_id) << "that of the mask";
    EXPECT_EQ(far->state, State::Moving) << "frame " << i << ": " << describe(far);
    EXPECT_NE(near->state, State::Moving) << "frame " << i << ": " << describe(near);
    EXPECT_NEAR(far->fused_velocity[0], 4, 0.3) << "frame " << i;
    EXPECT_GT(overlap(film.truth().ids, kMover, result.ids, mover).iou(), 0.8) << "frame " << i;
    EXPECT_GT(overlap(film.truth().ids, kParked, result.ids, parked).iou(), 0.8) << "frame " << i;
  }
  EXPECT_GE(divided, 7) << "of 14 frames";
}

// The tracker knows both already. The network unites them in all later masks, in every third frame.
TEST(SharedMask, OfKnownObjectsIsThatOfBoth) {
  Film<> film = two_in_one_mask(8);
  film.edit = [](int index, dot::Frame& frame) {
    if (index > 8 && index % 3 != 0) frame.masks.reset();
  };
  Tracker tracker(small_camera(), Options{});
  std::uint32_t parked = 0, mover = 0;
  for (int i = 0; i < 16; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* near = object_on(result, film.truth().ids, kParked);
    const ObjectResult* far = object_on(result, film.truth().ids, kMover);
    ASSERT_TRUE(near && far) << i;
    if (i == 7) parked = near->id, mover = far->id;
    if (i < 8) continue;
    EXPECT_EQ(near->id, parked) << "frame " << i;
    EXPECT_EQ(far->id, mover) << "frame " << i;
    EXPECT_EQ(far->state, State::Moving) << "frame " << i;
    EXPECT_EQ(near->state, State::Static) << "frame " << i;
  }
}

// Stereo may give a part of an object the depth of something else. The image of that part moves with the object.
TEST(SharedMask, OfOneObjectWithWrongDepthIsNotDivided) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, 0.5});
  film.degradation.noise = 1;
  film.degradation.depth_noise = 1e-4;
  film.add(kMover, straight({-1.8, 1.3, 6}, {3, 0, 0}));
  film.spoil = [](int, Rendering& seen) {
    dot::Mask mask;
    dot::crop_ids<std::uint32_t>(seen.ids.view(), kMover, {0, 0, seen.ids.width(), seen.ids.height()}, mask);
    for (int y = 0; y < mask.height(); ++y)
      for (int x = mask.width() / 2; x < mask.width(); ++x)
        if (mask.pixels(x, y)) seen.depth(mask.x + x, mask.y + y) *= 1.7f;
  };
  Tracker tracker(small_camera(), Options{});
  for (int i = 0; i < 14; ++i) {
    const Result& result = film.next(tracker);
    ASSERT_EQ(result.objects.size, 1u) << "frame " << i;
    const std::uint32_t id = result.objects[0].id;
    EXPECT_GT(overlap(film.truth().ids, kMover, result.ids, id).iou(), 0.9) << "frame " << i;
  }
}

// Masks that arrive three frames late go the same way. Each object that is shown has pixels of its own.
TEST(SharedMask, MayArriveLate) {
  Film<> film = two_in_one_mask(0);
  Tracker tracker(small_camera(), Options{});
  std::vector<dot::Image<std::uint32_t>> ids;
  std::size_t most = 0;
  for (int i = 0; i < 24; ++i) {
    dot::Frame frame = film.advance();
    ids.push_back(film.seen().ids);
    frame.masks.reset();
    if (i >= 3 && i % 3 == 0) {
      const dot::Image<std::uint32_t>& late = ids[static_cast<std::size_t>(i - 3)];
      Masks masks;
      masks.ids = {late.row(0), late.width(), late.height(), late.width() * 4, dot::PixelFormat::Id32};
      tracker.submit_masks(static_cast<std::uint64_t>(i - 3), masks);
    }
    const Result& result = tracker.track(frame);
    most = std::max(most, result.objects.size);
    for (const ObjectResult& o : result.objects) EXPECT_TRUE(o.area > 0 || o.reason != dot::Reason::None) << i;
  }
  EXPECT_EQ(most, 2u) << "both are found";
}

}  // namespace
