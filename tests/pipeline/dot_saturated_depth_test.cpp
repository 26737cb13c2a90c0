// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Depth that is cut off at a largest value, as by a simulator's far plane.

#include <gtest/gtest.h>

#include <algorithm>

#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::Result;
using dot::Suspicion;
using dot::Tracker;
using namespace dot::test;

constexpr float kFarthest = 9;  // metres; the yard's wall and the ground before it are farther away

/// A camera that drives past a car towards a wall. @param written metres, depth of what is beyond kFarthest.
Film<> drive(float written) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0.4, 0, 0.8});
  film.add(7, straight({1.5, 1.3, 7.5}));
  film.spoil = [written](int, Rendering& seen) {
    for (int y = 0; y < seen.depth.height(); ++y)
      std::replace_if(
          seen.depth.row(y), seen.depth.row(y) + seen.depth.width(), [](float z) { return z >= kFarthest; }, written);
  };
  return film;
}

TEST(SaturatedDepth, CountsAsNotMeasured) {
  Film<> cut_off = drive(kFarthest), with_holes = drive(0);
  Tracker tracker(small_camera()), expecting(small_camera());
  for (int i = 0; i < 12; ++i) {
    const Result& result = cut_off.next(tracker);
    const Result& expected = with_holes.next(expecting);
    ASSERT_EQ(result.camera.T_cur_prev, expected.camera.T_cur_prev) << i;
    ASSERT_EQ(result.objects.size, expected.objects.size) << i;
    for (std::size_t k = 0; k < result.objects.size; ++k)
      ASSERT_EQ(result.objects[k].state, expected.objects[k].state) << i;
    for (int y = 0; y < result.labels.height; ++y)
      ASSERT_TRUE(std::equal(result.labels.row(y), result.labels.row(y) + result.labels.width, expected.labels.row(y)))
          << i;
    ASSERT_EQ(result.diagnosis.reason, i < 7 ? Suspicion::None : Suspicion::SaturatedDepth) << i;
    ASSERT_EQ(expected.diagnosis.reason, Suspicion::None) << i;
  }
  EXPECT_GT(cut_off.next(tracker).diagnosis.figure, 0.3);
}

// Without noise all pixels of the wall have the same depth, which does not change when the camera moves sideways.
TEST(SaturatedDepth, IsNotAWallAcrossTheView) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0.5, 0, 0});
  Tracker tracker(small_camera());
  for (int i = 0; i < 12; ++i) {
    const Result& result = film.next(tracker);
    ASSERT_EQ(result.diagnosis.reason, Suspicion::None) << i;
    if (i == 0) continue;
    ASSERT_NEAR(result.camera.T_cur_prev[3], -0.05, 0.01) << i;
  }
}

}  // namespace
