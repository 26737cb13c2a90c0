// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// `track` in two steps, `label` and `prepare`: the same answers, earlier.

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>

#include "dot/tracker.hpp"
#include "support/result_copy.hpp"
#include "support/street.hpp"

namespace {

using dot::Frame;
using dot::Image;
using dot::Masks;
using dot::Result;
using dot::Tracker;
using namespace dot::test;

void expect_same_labels(const Result& a, const Result& b) { expect_same(ResultCopy(a), ResultCopy(b)); }

/// All of it, after `prepare`.
void expect_same_prepared(const Result& a, const Result& b) {
  expect_same_labels(a, b);
  EXPECT_EQ(a.too_little_depth, b.too_little_depth);
  EXPECT_EQ(a.diagnosis.reason, b.diagnosis.reason);
  EXPECT_EQ(a.diagnosis.figure, b.diagnosis.figure);
}

double milliseconds_of_points(const Result& result) {
  return result.stage_ms[static_cast<std::size_t>(dot::Stage::Points)];
}

/// A street with masks in some frames and without depth in one.
Film<> odd_street() {
  Film<> film = street();
  film.spoil = [](int i, Rendering& seen) {
    if (i == 6) seen.depth.fill(0);
  };
  film.edit = [](int i, Frame& frame) {
    if (i % 3 != 0) frame.masks.reset();
  };
  return film;
}

// The host prepares, in its own thread or in another, or leaves it to the next frame.
TEST(Label, AndPrepareAreTrack) {
  Film<> film = odd_street();
  Tracker whole(small_camera()), steps(small_camera());
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Result& expected = film.next(whole);
    const Result& result = steps.label(film.frame());
    expect_same_labels(result, expected);
    EXPECT_FALSE(result.too_little_depth);
    EXPECT_EQ(milliseconds_of_points(result), 0);
    if (i % 3 == 0) continue;
    if (i % 3 == 1) {
      steps.prepare();
    } else {
      std::thread other([&] { steps.prepare(); });
      expect_same_labels(result, expected);
      other.join();
    }
    expect_same_prepared(result, expected);
    EXPECT_GT(milliseconds_of_points(result), 0);
    const double once = milliseconds_of_points(result);
    steps.prepare();
    EXPECT_EQ(milliseconds_of_points(result), once) << "all is prepared";
  }
}

TEST(Label, LittleDepthIsToldByPrepare) {
  Film<> film = street();
  film.spoil = [](int i, Rendering& seen) {
    if (i == 2) seen.depth.fill(0);
  };
  Tracker tracker(small_camera());
  for (int i = 0; i < 3; ++i) {
    const Result& result = tracker.label(film.advance());
    EXPECT_FALSE(result.too_little_depth);
    tracker.prepare();
    EXPECT_EQ(result.too_little_depth, i == 2);
  }
}

// A network that answers before the frame is prepared.
TEST(Label, MasksMayComeBeforePrepare) {
  Film<> film = street();
  film.edit = [](int, Frame& frame) { frame.masks.reset(); };
  Tracker whole(small_camera()), steps(small_camera());
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const Result& expected = film.next(whole);
    expect_same_labels(steps.label(film.frame()), expected);
    const Image<std::uint32_t>& ids = film.seen().ids;
    Masks masks;
    masks.ids = {ids.row(0), ids.width(), ids.height(), ids.view().stride, dot::PixelFormat::Id32};
    whole.submit_masks(film.frame().id, masks);
    steps.submit_masks(film.frame().id, masks);
  }
}

TEST(Label, ABadFrameOrAResetMayFollow) {
  Film<> film = street();
  Tracker whole(small_camera()), steps(small_camera());
  for (int i = 0; i < 9; ++i) {
    SCOPED_TRACE(i);
    const Result& expected = film.next(whole);
    expect_same_labels(steps.label(film.frame()), expected);
    if (i == 2) {
      Frame bad = film.frame();
      bad.timestamp -= 1;
      EXPECT_THROW(steps.label(bad), std::invalid_argument);
    }
    if (i == 5) whole.reset(), steps.reset();
    if (i == 6) steps = Tracker(std::move(steps));
  }
  steps.reset();
  steps.prepare();
}

}  // namespace
