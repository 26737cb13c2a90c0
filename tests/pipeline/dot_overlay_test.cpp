// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// What is drawn over the image, on objects too, does not make them move.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "dot/dot.hpp"
#include "support/film.hpp"

namespace {

using dot::Dot;
using dot::ObjectResult;
using dot::Pinhole;
using dot::Result;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t parked = 1, ahead = 2;

/// White on black, like the figures of a camera's clock, over the columns [begin, end) of some rows.
void write(Rendering& seen, int begin, int end, int first_row, int end_row) {
  for (int y = first_row; y < end_row; ++y)
    for (int x = begin; x < end; ++x) {
      const bool is_white = (x / 4) % 3 == 0 || (y / 4) % 3 == 0;
      seen.grey(x, y) = is_white ? 255 : 0;
    }
}

/// A camera that drives past a parked car, at 1 m/s to the side and .5 m/s ahead. The car goes to the left in the
/// image.
Film<> passing() {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {1, 0, 0.5});
  film.degradation.noise = 1;
  film.add(parked, straight({2, 0.6, 9}));
  return film;
}

/// Frames from frame 10 on in which an object is called static and moving.
struct Counts {
  int frames = 0, still = 0, moving = 0;
};
Counts count(Film<>& film, std::uint32_t id, int frames) {
  Dot<> dot{Pinhole(small_camera())};
  Counts counts;
  for (int i = 0; i < frames; ++i) {
    const Result& result = film.next(dot);
    const ObjectResult* o = object_on(result, film.truth().ids, id);
    if (i < 10 || !o) continue;
    ++counts.frames;
    counts.still += o->state == State::Static, counts.moving += o->state == State::Moving;
  }
  return counts;
}

TEST(Overlay, OnAParkedCarDoesNotMakeItMove) {
  Film<> film = passing();
  film.spoil = [](int, Rendering& seen) { write(seen, 60, 240, 126, 138); };
  const Counts counts = count(film, parked, 40);
  EXPECT_EQ(counts.frames, 30);
  EXPECT_EQ(counts.moving, 0);
  EXPECT_GE(counts.still, 27);
}

// It hides more of the car than it leaves, like the car's own edges if it moved with the camera.
TEST(Overlay, IsKnownFromBeforeTheCarCameThere) {
  Film<> film = passing();
  film.spoil = [](int, Rendering& seen) { write(seen, 60, 170, 112, 146); };
  const Counts counts = count(film, parked, 40);
  EXPECT_EQ(counts.frames, 30);
  EXPECT_EQ(counts.moving, 0);
}

// Its edges stay in the image like those of an overlay. At first it has no mask.
TEST(Overlay, IsNotACarAheadOfTheSameSpeed) {
  for (const int first_mask : {0, 12}) {
    Film<> film = passing();
    film.add(ahead, straight({-0.5, 0.8, 7}, {1, 0, 0.5}));
    film.spoil = [first_mask](int i, Rendering& seen) {
      if (i >= first_mask) return;
      for (int y = 0; y < seen.ids.height(); ++y)
        for (int x = 0; x < seen.ids.width(); ++x)
          if (seen.ids(x, y) == ahead) seen.ids(x, y) = 0;
    };
    const Counts counts = count(film, ahead, 40);
    EXPECT_GE(counts.moving, counts.frames - 1) << first_mask;
    EXPECT_EQ(counts.frames, std::min(30, 40 - first_mask)) << first_mask;
    EXPECT_EQ(counts.still, 0) << first_mask;
  }
}

}  // namespace
