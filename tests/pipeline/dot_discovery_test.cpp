// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Options::discover_unknown: what moves is found without a mask, and what stands is not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

#include "dot/dot.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Dot;
using dot::Frame;
using dot::Image;
using dot::ObjectResult;
using dot::Options;
using dot::Pinhole;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t parked = 1, mover = 2;

Dot<> make_dot(bool discover = true) {
  Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  options.discover_unknown = discover;
  return Dot<>(Pinhole(small_camera()), options);
}

/// The network runs and sees nothing.
void no_masks(int, Frame& frame) { frame.masks = dot::Masks{}; }

/// Sensors as they are, and a network that is blind.
Film<> blind_film() {
  Film<> film;
  film.degradation.noise = 1.5;
  film.degradation.depth_noise = 0.002;
  film.degradation.missing_depth = 0.02;
  film.edit = no_masks;
  return film;
}

/// Pixels labelled moving on a body, of the body, and elsewhere.
struct Moving {
  int on = 0, body = 0, elsewhere = 0;
};

Moving moving_pixels(const Result& result, const Image<std::uint32_t>& truth, std::uint32_t body) {
  Moving m;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const bool said = result.labels(x, y) == static_cast<std::uint8_t>(State::Moving), on = truth(x, y) == body;
      m.on += said && on, m.body += on, m.elsewhere += said && !on;
    }
  return m;
}

/// From the given frame on: the mover found by 60 % of its pixels, and next to nothing beside it.
void expect_found(Film<>& film, int frames, int from) {
  Dot<> dot = make_dot();
  std::uint32_t id = 0;
  for (int i = 0; i < frames; ++i) {
    const Result& result = film.next(dot);
    const Moving m = moving_pixels(result, film.truth().ids, mover);
    const std::string where = "frame " + std::to_string(i) + ": " + std::to_string(m.on) + " of " +
                              std::to_string(m.body) + ", elsewhere " + std::to_string(m.elsewhere);
    EXPECT_LE(m.elsewhere, 0.25 * m.body) << where;
    if (i < from) continue;
    EXPECT_GE(m.on, 0.6 * m.body) << where;
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    ASSERT_NE(o, nullptr) << where;
    EXPECT_TRUE(o->discovered && !o->segmented && o->instance_id == 0) << where;
    if (id == 0) id = o->id;
    EXPECT_EQ(o->id, id) << where;
  }
}

/// Nothing at all, in any frame.
void expect_nothing(Film<>& film, int frames) {
  Dot<> dot = make_dot();
  for (int i = 0; i < frames; ++i) {
    const Result& result = film.next(dot);
    EXPECT_EQ(result.objects.size, 0u) << "frame " << i << ": " << describe(result.objects.data);
    EXPECT_EQ(result.camera.status, i == 0 ? CameraStatus::FirstFrame : CameraStatus::Tracked) << "frame " << i;
  }
}

TEST(Discovery, FindsWhatCrosses) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.add(parked, straight({2.6, 1.3, 9}));
  film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
  expect_found(film, 18, 7);
}

// It stays at its place in the image, and covers there what it would contradict if it were not known.
TEST(Discovery, KeepsWhatDrivesAhead) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {0, 0, 2});
  film.add(mover, straight({0.3, 1.3, 7}, {0, 0, 2}));
  expect_found(film, 22, 9);
}

// A host without a network gives no masks at all, not even empty ones: no frame was ever segmented.
TEST(Discovery, FindsWhatCrossesWhenNoMaskEverComes) {
  Film<> film = blind_film();
  film.edit = [](int, Frame& frame) { frame.masks.reset(); };
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.add(parked, straight({2.6, 1.3, 9}));
  film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
  expect_found(film, 18, 7);
}

// A lidar of 10 Hz beside a camera of 20 or 30 Hz: the frames between have no depth.
TEST(Discovery, FindsWhatCrossesWithDepthInSomeFrames) {
  for (const int every : {2, 3}) {
    SCOPED_TRACE(every);
    Film<> film = blind_film();
    film.interval = 0.1 / every;
    film.spoil = [every](int i, Rendering& seen) {
      if (i % every != 0) seen.depth.fill(0);
    };
    film.camera_path = straight({0, 0, 0}, {0, 0, 1});
    film.add(parked, straight({2.6, 1.3, 9}));
    film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
    expect_found(film, 18 * every, 10 * every);
  }
}

// The same, and nearly all depth of the mover fails in some frames: it is not found there but carried on.
TEST(Discovery, CarriesOnWhatItFoundWhenNoMaskEverComes) {
  for (const int first : {4, 7, 10}) {
    SCOPED_TRACE(first);
    Film<> film = blind_film();
    film.edit = [](int, Frame& frame) { frame.masks.reset(); };
    film.camera_path = straight({0, 0, 0}, {0, 0, 1});
    film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
    film.spoil = [first](int i, Rendering& seen) {
      if (i < first || i > first + 2) return;
      Random random(static_cast<unsigned>(i));
      for (int y = 0; y < seen.depth.height(); ++y)
        for (int x = 0; x < seen.depth.width(); ++x)
          if (seen.ids(x, y) == mover && random.uniform() < 0.97) seen.depth(x, y) = 0;
    };
    Dot<> dot = make_dot();
    Moving m;
    for (int i = 0; i < 18; ++i) m = moving_pixels(film.next(dot), film.truth().ids, mover);
    EXPECT_GE(m.on, 0.6 * m.body);
    EXPECT_LE(m.elsewhere, 0.25 * m.body);
  }
}

// What was segmented before a reset, a gap or a loss of the camera tells nothing of what comes after it.
TEST(Discovery, GoesOnWithoutTheLastSegmentation) {
  enum class Break { Reset, Gap, Loss };
  for (const Break how : {Break::Reset, Break::Gap, Break::Loss}) {
    SCOPED_TRACE(static_cast<int>(how));
    Film<> film = blind_film();
    film.add(mover, straight({-3.5, 1.3, 8}, {1.5, 0, 0}));
    double shift = 0;
    film.edit = [&](int i, Frame& frame) {
      frame.timestamp += shift;
      if (i > 2) frame.masks.reset();
    };
    Dot<> dot = make_dot();
    const double min_phi = dot.options().camera.min_phi, unexpected = dot.options().camera.min_phi_unexpected;
    Moving m;
    for (int i = 0; i < 24; ++i) {
      if (i == 8 && how == Break::Reset) dot.reset();
      if (i == 8 && how == Break::Gap) shift = 2;
      const bool lost = i == 8 && how == Break::Loss;
      dot.camera_estimator.settings.min_phi = lost ? 2 : min_phi;
      dot.camera_estimator.settings.min_phi_unexpected = lost ? 2 : unexpected;
      const Result& result = film.next(dot);
      if (lost) {
        EXPECT_EQ(result.camera.status, CameraStatus::Lost);
      }
      m = moving_pixels(result, film.truth().ids, mover);
      EXPECT_LE(m.elsewhere, 0.25 * m.body) << i;
    }
    EXPECT_GE(m.on, 0.6 * m.body);
  }
}

// What was found stops, and may be dropped. Until it is, and in its last frame, the results say so.
TEST(Discovery, NothingThatWasReportedGoesWithoutAReason) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {0, 0, 0.3});
  film.add(mover, [](double t) { return SE3d::translation(Vector3<double>(-3.5 + 2.5 * std::min(t, 1.5), 1.3, 8)); });
  Dot<> dot = make_dot();
  std::map<std::uint32_t, dot::Reason> before;
  int hidden = 0, lost = 0;
  for (int i = 0; i < 60; ++i) {
    std::map<std::uint32_t, dot::Reason> now;
    for (const ObjectResult& o : film.next(dot).objects) {
      now[o.id] = o.reason;
      lost += o.reason == dot::Reason::Lost;
      if (o.reason != dot::Reason::Hidden) continue;
      ++hidden;
      EXPECT_EQ(o.area, 0) << i;
    }
    for (const auto& [id, reason] : before) {
      EXPECT_TRUE(reason == dot::Reason::Lost || now.count(id)) << "frame " << i << ", object " << id;
    }
    before = now;
  }
  EXPECT_GT(hidden, 0);
  EXPECT_GT(lost, 0);
}

TEST(Discovery, FindsWhatGoesAway) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.add(mover, straight({0.3, 1.3, 4.5}, {0, 0, 3}));
  expect_found(film, 16, 7);
}

TEST(Discovery, FindsWhatComesNearer) {
  Film<> film = blind_film();
  film.add(mover, straight({0.8, 1.3, 9}, {0, 0, -3}));
  expect_found(film, 16, 9);
}

// Parallax hides and uncovers parts of the wall behind the boxes, the exposure drifts, and there is noise.
TEST(Discovery, StandingThingsAreNotFound) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {1.5, 0, 1});
  film.add(parked, straight({1.6, 1.3, 6}));
  film.add(mover, straight({-1.2, 1.3, 8}));
  film.spoil = [](int i, Rendering& seen) {
    Degradation exposure;
    exposure.gain = i % 8 < 4 ? 1.0 : 0.85;
    exposure.offset = i % 5;
    seen = degraded(seen, exposure);
  };
  expect_nothing(film, 20);
}

TEST(Discovery, NoiseBeforeAStandingCameraIsNotFound) {
  Film<> film = blind_film();
  film.degradation.noise = 4;
  film.degradation.depth_noise = 0.006;
  film.degradation.missing_depth = 0.1;
  film.add(parked, straight({1.6, 1.3, 6}));
  expect_nothing(film, 20);
}

// Wrong surfaces that come and go are inconsistent, but no motion fits them.
TEST(Discovery, FlickeringDepthIsNotFound) {
  Film<> film = blind_film();
  film.camera_path = straight({0, 0, 0}, {0, 0, 1});
  film.spoil = [](int i, Rendering& seen) {
    for (int y = 60; y < 110; ++y)
      for (int x = 100; x < 180; ++x)
        if (i % 4 < 2) seen.depth(x, y) *= 0.5f;
  };
  expect_nothing(film, 20);
}

// Beside the mover, the textured wall seems to be as near as the mover in every other frame.
TEST(Discovery, WhatStandsIsTakenOutOfTheMask) {
  Film<> film = blind_film();
  film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
  film.spoil = [&](int i, Rendering& seen) {
    const Image<std::uint32_t>& ids = film.truth().ids;
    int left = ids.width(), right = 0, top = ids.height(), bottom = 0;
    for (int y = 0; y < ids.height(); ++y)
      for (int x = 0; x < ids.width(); ++x)
        if (ids(x, y) == mover) {
          left = std::min(left, x), right = std::max(right, x);
          top = std::min(top, y), bottom = std::max(bottom, y);
        }
    for (int y = std::max(0, top - 10); y < bottom; ++y)
      for (int x = right + 1; x < std::min(ids.width(), right + 80); ++x)
        if (i % 2 == 1 && left < right) seen.depth(x, y) = 7.3f;
  };
  expect_found(film, 18, 8);
}

// It moves in the image, but nothing of the scene does: its depth is that of the ground.
TEST(Discovery, ShadowIsNotFound) {
  Film<> film = blind_film();
  film.spoil = [](int i, Rendering& seen) {
    for (int y = 170; y < 220; ++y)
      for (int x = 20 + 6 * i; x < 100 + 6 * i; ++x) seen.grey(x, y) = static_cast<std::uint8_t>(seen.grey(x, y) / 2);
  };
  expect_nothing(film, 16);
}

TEST(Discovery, LeavesWhatTheNetworkSees) {
  Film<> film = blind_film();
  film.edit = nullptr;
  film.add(parked, straight({1.6, 1.3, 7}));
  film.add(mover, straight({-2.5, 1.3, 6.5}, {2, 0, 0}));
  Dot<> dot = make_dot();
  for (int i = 0; i < 14; ++i) {
    const Result& result = film.next(dot);
    EXPECT_EQ(result.objects.size, 2u) << "frame " << i;
    for (const ObjectResult& o : result.objects) EXPECT_FALSE(o.discovered) << "frame " << i << ": " << describe(&o);
  }
}

TEST(Discovery, NetworkTakesOverWithTheSameId) {
  Film<> film = blind_film();
  film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
  film.edit = [](int i, Frame& frame) {
    if (i < 12) no_masks(i, frame);
  };
  Dot<> dot = make_dot();
  std::uint32_t id = 0;
  for (int i = 0; i < 16; ++i) {
    const Result& result = film.next(dot);
    if (i < 11) continue;
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    ASSERT_NE(o, nullptr) << "frame " << i;
    if (i == 11) id = o->id;
    EXPECT_EQ(o->id, id) << "frame " << i;
    EXPECT_EQ(o->discovered, i < 12) << "frame " << i;
    EXPECT_EQ(o->segmented, i >= 12) << "frame " << i;
    EXPECT_EQ(o->state, State::Moving) << "frame " << i;
  }
}

TEST(Discovery, IsOffByDefault) {
  Film<> film = blind_film();
  film.add(mover, straight({-3.5, 1.3, 8}, {2.5, 0, 0}));
  Dot<> dot = make_dot(false);
  EXPECT_FALSE(Options{}.discover_unknown);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(film.next(dot).objects.size, 0u) << "frame " << i;
}

}  // namespace
