// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A part of the image that does not move with the scene does not hold the camera for long.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dot/dot.hpp"
#include "support/film.hpp"
#include "support/stereo_dot.hpp"

namespace {

using dot::Dot;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t parked = 1;
constexpr int kFirstRow = 170;  ///< of the part, which reaches to the bottom

/// Pillars at several distances, without masks: before a bare wall a camera that turns looks like one that moves.
void add_pillars(Film<>& film) {
  unsigned seed = 500;
  for (const Vector3<double>& at : {Vector3<double>(-2.5, -1, 6), {0.5, -1.5, 10}, {4, -1, 7}, {6.5, -1, 8}}) {
    Body pillar = box(0, {0.7, 2, 0.7}, seed += 10, 0.25, 1.2);
    for (Quad& quad : pillar.quads) quad.centre += at;
    film.add(pillar, straight(Vector3<double>::Zero()));
  }
}

/// A camera that moves to the side past a parked car.
Film<> passing(bool has_part) {
  Film<> film;
  film.camera_path = straight(Vector3<double>::Zero(), {1.2, 0, 0.4});
  film.degradation.noise = 1;
  add_pillars(film);
  film.add(parked, straight({2.5, 0, 9}));
  if (has_part) {
    const Texture texture(77, 10, 40, 40);
    film.spoil = [texture](int, Rendering& seen) {
      for (int y = kFirstRow; y < seen.grey.height(); ++y)
        for (int x = 0; x < seen.grey.width(); ++x) {
          seen.grey(x, y) = static_cast<std::uint8_t>(std::clamp(texture(x, y), 0.0, 255.0));
          seen.depth(x, y) = 1.2F;
          seen.ids(x, y) = 0;
        }
    };
  }
  return film;
}

TEST(FixedPart, DoesNotHoldTheCamera) {
  Film<> film = passing(true);
  Dot<> dot = stereo_dot();
  for (int i = 0; i < 35; ++i) {
    const Result& result = film.next(dot);
    if (i < 10) continue;
    const auto& T = result.camera.T_cur_prev;
    const Vector3<double> error = Vector3<double>(T[3], T[7], T[11]) - film.T_c().t;
    EXPECT_LT(error.norm(), 0.02) << "frame " << i;
    const dot::ObjectResult* o = object_on(result, film.truth().ids, parked);
    ASSERT_TRUE(o) << "frame " << i;
    if (i >= 28) {
      EXPECT_EQ(o->state, State::Static) << "frame " << i << ": " << describe(o);
      EXPECT_EQ(result.diagnosis.reason, dot::Suspicion::FixedPart) << "frame " << i;
      EXPECT_NEAR(result.diagnosis.figure, 0.28, 0.06) << "frame " << i;
    }
  }
}

// The lorry covers a third of the image, and the scene stays in the rest of it.
TEST(FixedPart, IsNotTheSceneInWhichALorryPassesAStandingCamera) {
  Film<> film;
  film.degradation.noise = 1;
  add_pillars(film);
  film.add(parked, straight({2.5, 0, 9}));
  constexpr std::uint32_t lorry = 9;
  film.add(box(lorry, {4, 1.5, 0.8}, 900, 0.25, 1.2), straight({-12, 0.5, 6}, {6, 0, 0}));
  film.spoil = [](int, Rendering& seen) {  // it gets no mask
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == lorry) seen.ids(x, y) = 0;
  };
  Dot<> dot = stereo_dot();
  for (int i = 0; i < 40; ++i) {
    const Result& result = film.next(dot);
    EXPECT_NE(result.diagnosis.reason, dot::Suspicion::FixedPart) << i;
    if (i < 2) continue;
    const auto& T = result.camera.T_cur_prev;
    EXPECT_LT(std::hypot(T[3], T[7], T[11]), 0.02) << i;
    const dot::ObjectResult* car = object_on(result, film.truth().ids, parked);
    EXPECT_FALSE(car && car->state == State::Moving) << i << ' ' << describe(car);
  }
}

// A belt without a mask starts to run after a second, at .8 m/s, and carries an object. It and the object have more of
// the image than what stands and has texture.
TEST(Belt, BeforeAStandingCameraIsNotTheScene) {
  Film<> film;
  film.degradation.noise = 6;
  add_pillars(film);
  film.add(parked, straight({2.5, -0.9, 9}));
  constexpr std::uint32_t belt = 9;
  const auto from = [](const Vector3<double>& start) {
    return [start](double t) { return SE3d::translation(start + Vector3<double>(0.8 * std::max(0.0, t - 1), 0, 0)); };
  };
  film.add(box(belt, {12, 1.5, 0.8}, 900, 0.25, 1.2), from({-3, 1, 6}));
  film.add(box(2, {0.4, 0.3, 0.3}, 950, 0.15, 0.6), from({-1.5, 0.6, 4.8}));
  film.spoil = [](int, Rendering& seen) {
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == belt) seen.ids(x, y) = 0;
  };
  Dot<> dot = stereo_dot();
  for (int i = 0; i < 40; ++i) {
    const Result& result = film.next(dot);
    EXPECT_NE(result.diagnosis.reason, dot::Suspicion::FixedPart) << i;
    if (i < 2) continue;
    const auto& T = result.camera.T_cur_prev;
    EXPECT_LT(std::hypot(T[3], T[7], T[11]), 0.01) << i;
    const dot::ObjectResult* car = object_on(result, film.truth().ids, parked);
    EXPECT_FALSE(car && car->state == State::Moving) << i << ' ' << describe(car);
  }
}

TEST(FixedPart, IsNotSuspectedInAScene) {
  Film<> film = passing(false);
  Dot<> dot = stereo_dot();
  for (int i = 0; i < 30; ++i) EXPECT_EQ(film.next(dot).diagnosis.reason, dot::Suspicion::None) << "frame " << i;
}

}  // namespace
