// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Sensors and networks that do not come with every frame: images that a driver repeats, masks and depth in turn.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "dot/tracker.hpp"
#include "support/street.hpp"

namespace {

using dot::Frame;
using dot::ObjectResult;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

/// How many frames say what of the two cars, from some frame on.
struct Count {
  int frames = 0, mover_moves = 0, mover_stands = 0, parked_moves = 0;

  void add(const Result& result, const Film<>& film) {
    ++frames;
    const ObjectResult* car = object_on(result, film.truth().ids, mover);
    mover_moves += car && car->state == State::Moving;
    mover_stands += car && car->state == State::Static;
    const ObjectResult* still = object_on(result, film.truth().ids, parked);
    parked_moves += still && still->state == State::Moving;
  }
};

class Repeated : public testing::TestWithParam<int> {};

// A camera of 10 Hz in a loop of 20 or 30 Hz: each image comes again, with its depth and with a new time.
TEST_P(Repeated, ImagesAreNoEvidenceThatAMoverStands) {
  const int times = GetParam();
  Film<> film = street();
  Tracker tracker(small_camera());
  Count count;
  dot::Suspicion suspicion = dot::Suspicion::None;
  for (int i = 0; i < 16; ++i) {
    Frame frame = film.advance();
    for (int k = 0; k < times; ++k) {
      frame.id = static_cast<std::uint64_t>(times * i + k);
      frame.timestamp = film.epoch + film.interval * (i + 1.0 * k / times);
      const Result& result = tracker.track(frame);
      suspicion = result.diagnosis.reason;
      if (i < 6) continue;
      count.add(result, film);
      const ObjectResult* car = object_on(result, film.truth().ids, mover);
      ASSERT_TRUE(car);
      EXPECT_NEAR(car->fused_velocity[0], 3, 0.2) << i;
    }
  }
  EXPECT_EQ(suspicion, times > 1 ? dot::Suspicion::RepeatedImages : dot::Suspicion::None);
  EXPECT_EQ(count.mover_stands, 0) << "of " << count.frames;
  EXPECT_GE(count.mover_moves, 0.9 * count.frames);
  EXPECT_EQ(count.parked_moves, 0);
}

// The same through a video codec, which gives each copy of an image its own noise.
TEST(Repeated, ImagesWithOtherNoiseAreNoEvidenceThatAMoverStands) {
  Film<> film = street();
  film.degradation.noise = 1;
  Tracker tracker(small_camera());
  Random random(3);
  std::vector<std::uint8_t> copy;
  Count count;
  dot::Suspicion suspicion = dot::Suspicion::None;
  for (int i = 0; i < 16; ++i) {
    const Frame original = film.advance();
    const auto* grey = static_cast<const std::uint8_t*>(original.image.data);
    for (int k = 0; k < 2; ++k) {
      copy.assign(grey, grey + original.image.width * original.image.height);
      for (std::uint8_t& g : copy)
        g = static_cast<std::uint8_t>(std::clamp(std::round(g + random.normal(1.5)), 0.0, 255.0));
      Frame frame = original;
      frame.image.data = copy.data();
      frame.id = static_cast<std::uint64_t>(2 * i + k);
      frame.timestamp = film.epoch + film.interval * (i + 0.5 * k);
      const Result& result = tracker.track(frame);
      suspicion = result.diagnosis.reason;
      if (i >= 6) count.add(result, film);
    }
  }
  EXPECT_EQ(suspicion, dot::Suspicion::RepeatedImages);
  EXPECT_EQ(count.mover_stands, 0) << "of " << count.frames;
  EXPECT_GE(count.mover_moves, 0.9 * count.frames);
  EXPECT_EQ(count.parked_moves, 0);
}

INSTANTIATE_TEST_SUITE_P(Sensors, Repeated, testing::Values(1, 2, 3));

// An image that stays for seconds is that of a camera without noise before a scene at rest.
TEST(Repeated, ImagesOfASceneAtRestSayThatItStands) {
  Film<> film = street();
  Tracker tracker(small_camera());
  for (int i = 0; i < 8; ++i) film.next(tracker);
  Frame frame = film.frame();
  State last = State::Background;
  for (int k = 1; k <= 30; ++k) {
    ++frame.id;
    frame.timestamp += film.interval;
    const ObjectResult* car = object_on(tracker.track(frame), film.truth().ids, mover);
    last = car ? car->state : State::Background;
  }
  EXPECT_EQ(last, State::Static);
}

// A network of 5 Hz and depth of 10 Hz beside a camera of 20 Hz: no frame has both masks and depth. The outline is
// carried by the object's motion, for which it needs the depth of a later frame.
TEST(InTurn, MasksAndDepthAreBroughtTogether) {
  Film<> film = street();
  film.interval = 0.05;
  film.spoil = [](int i, Rendering& seen) {
    if (i % 2 == 1) seen.depth.fill(0);
  };
  film.edit = [](int i, Frame& frame) {
    if (i % 4 != 1) frame.masks.reset();
  };
  Tracker tracker(small_camera());
  std::set<std::uint32_t> ids;
  Count count;
  for (int i = 0; i < 30; ++i) {
    const Result& result = film.next(tracker);
    for (const ObjectResult& o : result.objects) ids.insert(o.id);
    if (i < 10) continue;
    count.add(result, film);
    const ObjectResult* car = object_on(result, film.truth().ids, mover);
    ASSERT_TRUE(car) << i;
    EXPECT_GT(overlap(film.truth().ids, mover, result.ids, car->id).iou(), 0.92) << i;
  }
  EXPECT_EQ(ids.size(), 2u);
  EXPECT_GE(count.mover_moves, 0.9 * count.frames);
  EXPECT_EQ(count.parked_moves, 0);
}

}  // namespace
