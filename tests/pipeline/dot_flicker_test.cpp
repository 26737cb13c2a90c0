// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Bands of lamps that flicker, as a rolling shutter sees them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "dot/dot.hpp"
#include "support/film.hpp"
#include "support/stereo_dot.hpp"

namespace {

using dot::Dot;
using dot::Result;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t standing = 1, moving = 2;

/// A camera that moves past a standing car and one that drives. The light of each row is that of a lamp at 100 Hz, of
/// which 2.6 periods fit into the time of an image, seen at a rate that is no part of it.
Film<> under_lamps(double amplitude) {
  Film<> film;
  film.camera_path = straight(Vector3<double>::Zero(), {0.8, 0, 0.4});
  film.degradation.noise = 1;
  film.add(standing, straight({2.2, 1.3, 9}));
  film.add(moving, straight({-2.5, 1.3, 9}, {1.6, 0, 0}));
  film.spoil = [amplitude](int frame, Rendering& seen) {
    for (int y = 0; y < seen.grey.height(); ++y) {
      const double turns = 2.6 * y / seen.grey.height() + 0.37 * frame;
      const double light = 1 + amplitude * std::sin(6.283185307179586 * turns);
      for (int x = 0; x < seen.grey.width(); ++x)
        seen.grey(x, y) = static_cast<std::uint8_t>(std::clamp(light * seen.grey(x, y) + 0.5, 0.0, 255.0));
    }
  };
  return film;
}

TEST(Flicker, ChangesNoDecision) {
  for (const double amplitude : {0.0, 0.1, 0.15}) {
    Film<> film = under_lamps(amplitude);
    Dot<> dot = stereo_dot();
    for (int i = 0; i < 20; ++i) {
      const Result& result = film.next(dot);
      if (i == 0) continue;
      ASSERT_EQ(result.camera.status, dot::CameraStatus::Tracked) << "frame " << i << ", amplitude " << amplitude;
      const auto& T = result.camera.T_cur_prev;
      const Vector3<double> error = Vector3<double>(T[3], T[7], T[11]) - film.T_c().t;
      EXPECT_LT(error.norm(), i == 1 ? 0.04 : 0.015) << "frame " << i << ", amplitude " << amplitude;
      if (i < 6) continue;
      for (const auto& [id, state] : {std::pair{standing, State::Static}, {moving, State::Moving}}) {
        const dot::ObjectResult* o = object_on(result, film.truth().ids, id);
        ASSERT_TRUE(o) << "frame " << i << ", amplitude " << amplitude;
        EXPECT_EQ(o->state, state) << "frame " << i << ", amplitude " << amplitude << ": " << describe(o);
      }
    }
  }
}

}  // namespace
