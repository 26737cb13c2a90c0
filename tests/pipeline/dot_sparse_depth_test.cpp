// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Depth of a few percent of the pixels, as a lidar's points give it, a small time-of-flight camera, or a SLAM host.

#include <gtest/gtest.h>

#include "dot/tracker.hpp"
#include "support/street.hpp"

namespace {

using dot::CameraStatus;
using dot::DepthSource;
using dot::ObjectResult;
using dot::Options;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

/// Leaves beams of a lidar, `rows` pixels apart, that measure every `columns` pixels.
auto beams(int rows, int columns) {
  return [=](int index, Rendering& seen) {
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (y % rows != rows / 2 || (x + index) % columns != 0) seen.depth(x, y) = 0;
  };
}

void expect_tells_them_apart(int rows, int columns) {
  Film<> film = street();
  film.spoil = beams(rows, columns);
  Options options;
  options.depth_noise.source = DepthSource::Lidar;
  Tracker tracker(small_camera(), options);
  for (int i = 0; i < 10; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    if (i < 5) continue;
    ASSERT_EQ(result.objects.size, 2u) << i;
    const bool first_is_parked = result.objects[0].instance_id == parked;
    const ObjectResult &stands = result.objects[first_is_parked ? 0 : 1],
                       &moves = result.objects[first_is_parked ? 1 : 0];
    EXPECT_EQ(stands.state, State::Static) << i;
    EXPECT_EQ(moves.state, State::Moving) << i;
    EXPECT_NEAR(moves.fused_velocity[0], 3, 0.5) << i;
  }
}

TEST(SparseDepth, OfManyBeams) {
  expect_tells_them_apart(5, 4);
  expect_tells_them_apart(6, 3);
}
TEST(SparseDepth, OfFewBeams) { expect_tells_them_apart(12, 2); }

/// Leaves one pixel of each 8x8, and of the objects none if `background` is true.
auto points(bool background) {
  return [=](int, Rendering& seen) {
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (y % 8 != 4 || x % 8 != 4 || (background && seen.ids(x, y) != 0)) seen.depth(x, y) = 0;
  };
}

TEST(SparseDepth, OfPointsFarApart) {
  Film<> film = street();
  film.spoil = points(false);
  Tracker tracker(small_camera(), {});
  for (int i = 0; i < 10; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    for (const ObjectResult& o : result.objects)
      EXPECT_NE(o.state, o.instance_id == parked ? State::Moving : State::Static) << i;
  }
}

// Depth that is interpolated from what is about an object is not the object's.
TEST(SparseDepth, OfPointsOnTheBackgroundAloneDecidesNoObject) {
  Film<> film = street();
  film.spoil = points(true);
  Tracker tracker(small_camera(), {});
  for (int i = 0; i < 10; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    ASSERT_EQ(result.objects.size, 2u) << i;
    for (const ObjectResult& o : result.objects) {
      EXPECT_EQ(o.state, State::NotObservable) << i;
      EXPECT_TRUE(i <= 1 || o.reason == dot::Reason::TooLittleDepth) << i;
    }
  }
}

}  // namespace
