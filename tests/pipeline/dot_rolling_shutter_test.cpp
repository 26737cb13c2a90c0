// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// A hand-held camera that reads its rows one after another.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "dot/dot.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Dot;
using dot::ObjectResult;
using dot::Pinhole;
using dot::Result;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t standing = 1, moving = 2;

/// Shaken by up to 45 degrees a second, twice a second about one axis and less often about the other.
Film<> shaken(double readout) {
  Film<> film;
  film.interval = 1.0 / 30;
  film.readout = readout;
  film.degradation.noise = 2;
  film.camera_path = [](double t) {
    const Vector3<double> turned(0.062 * std::sin(12.6 * t), 0.08 * std::sin(9.4 * t + 1), 0);
    return dot::SE3d{dot::so3::exp(turned), Vector3<double>(0.1 * t, 0, 0.2 * t)};
  };
  film.add(standing, straight({1.3, 1.2, 5}));
  film.add(moving, straight({-1.8, 1.2, 5}, {0.7, 0, 0}));
  return film;
}

TEST(RollingShutterPipeline, WhatStandsIsNotCalledMoving) {
  for (const double readout : {0.0, 0.03}) {
    SCOPED_TRACE(readout);
    Film<> film = shaken(readout);
    Dot<> dot{Pinhole(small_camera())};
    int stands = 0, moves = 0, frames = 0;
    for (int i = 0; i < 26; ++i) {
      const Result& result = film.next(dot);
      if (i < 8) continue;
      ++frames;
      ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
      const ObjectResult *still = object_on(result, film.truth().ids, standing),
                         *mover = object_on(result, film.truth().ids, moving);
      ASSERT_TRUE(still && mover) << i;
      EXPECT_NE(still->state, State::Moving) << i << ' ' << describe(still);
      EXPECT_NE(mover->state, State::Static) << i << ' ' << describe(mover);
      stands += still->state == State::Static, moves += mover->state == State::Moving;
    }
    EXPECT_GE(stands, 0.9 * frames);
    EXPECT_GE(moves, 0.9 * frames);
  }
}

}  // namespace
