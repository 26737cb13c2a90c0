// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// When the camera's motion is a guess, nothing is concluded from it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "dot/dot.hpp"
#include "support/film.hpp"
#include "support/stereo_dot.hpp"

namespace {

using dot::CameraStatus;
using dot::Dot;
using dot::Frame;
using dot::ObjectResult;
using dot::Result;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t parked = 1;

/// A camera that drives on and jumps aside by `jump` metres between the frames 7 and 8.
Film<> jumping(double jump) {
  Film<> film;
  film.camera_path = [jump](double t) {
    return dot::SE3d::translation(Vector3<double>(t > 0.75 ? jump : 0, 0, 0.5 * t));
  };
  film.degradation.noise = 1;
  film.add(parked, straight({1.0, 1.3, 8}));
  return film;
}

/// Lets the next frame's camera be lost, or not.
void lose(Dot<>& dot, bool lost) {
  dot::CameraSettings& settings = dot.camera_estimator.settings;
  settings = dot.options().camera;
  if (lost) settings.min_phi = settings.min_phi_unexpected = 2;  // nothing correlates that well
}

/// A parked car is not called moving, and no velocity is told that is more than its errors.
void expect_parked(const Film<>& film, const Result& result, int i) {
  const ObjectResult* o = object_on(result, film.truth().ids, parked);
  ASSERT_TRUE(o) << "frame " << i;
  EXPECT_NE(o->state, State::Moving) << "frame " << i << ": " << describe(o);
  if (o->reason != dot::Reason::None) return;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(std::abs(o->velocity[k]), 4 * std::sqrt(o->velocity_covariance[4 * k])) << "frame " << i << " axis " << k;
  }
}

TEST(LostCamera, MakesNothingMove) {
  for (const double jump : {0.1, 0.2, 0.3})
    for (const int first_mask : {0, 6, 7, 8}) {
      SCOPED_TRACE(std::to_string(jump) + " m, first mask in frame " + std::to_string(first_mask));
      Film<> film = jumping(jump);
      film.edit = [first_mask](int i, Frame& frame) {
        if (i < first_mask) frame.masks.reset();
      };
      Dot<> dot = stereo_dot();
      for (int i = 0; i < 14; ++i) {
        lose(dot, i == 8);
        const Result& result = film.next(dot);
        if (i == 8) {
          ASSERT_EQ(result.camera.status, CameraStatus::Lost);
          // The guess is off by the jump, and its covariance says that it may be.
          EXPECT_GT(3 * std::sqrt(result.camera.covariance[0]), jump);
        } else if (i > 8) {
          EXPECT_EQ(result.camera.status, CameraStatus::Tracked) << i;
        }
        if (i >= first_mask) expect_parked(film, result, i);
      }
    }
}

// After a gap nothing is known of the motion, and a host that takes every interval into its graph must see that.
TEST(LostCamera, AGapIsToldToBeUncertain) {
  for (const double gap : {5.0, 1e9}) {  // seconds
    SCOPED_TRACE(gap);
    Film<> film = jumping(0);
    film.edit = [gap](int i, Frame& frame) { frame.timestamp += i >= 5 ? gap : 0; };
    Dot<> dot = stereo_dot();
    for (int i = 0; i < 8; ++i) {
      const Result& result = film.next(dot);
      const auto sigma = [&](std::size_t k) { return std::sqrt(result.camera.covariance[7 * k]); };
      if (i == 0) {
        EXPECT_EQ(sigma(0), 0) << "no motion leads to the first frame";
      }
      if (i == 5) {
        ASSERT_EQ(result.camera.status, CameraStatus::FirstFrame);
        EXPECT_GT(sigma(2), 50);
        EXPECT_LT(sigma(2), 1e4) << "a finite one, after a gap of any length";
        EXPECT_GT(sigma(4), 1);
      }
      if (i == 4 || i == 7) {
        EXPECT_EQ(result.camera.status, CameraStatus::Tracked);
        EXPECT_LT(sigma(2), 0.05);
      }
    }
  }
}

// A frame in which the camera is lost and that has no depth to go on from: the next one is aligned to the frame before.
// The way since that is known well, but the last interval no better than the guess.
TEST(LostCamera, AGuessThatIsMadeGoodIsToldToBeUncertain) {
  Film<> film = jumping(0.2);
  film.spoil = [](int i, Rendering& seen) {
    if (i != 8) return;
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (seen.ids(x, y) == 0) seen.depth(x, y) = 0;
  };
  Dot<> dot = stereo_dot();
  for (int i = 0; i < 14; ++i) {
    lose(dot, i == 8);
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    const Vector3<double> off = (film.T_c().inverse() * dot::SE3d::from_row_major(result.camera.T_cur_prev)).t;
    for (int k = 0; k < 3 && i > 0; ++k)
      EXPECT_LT(std::abs(off[k]), 4 * std::sqrt(result.camera.covariance[static_cast<std::size_t>(7 * k)]) + 2e-3);
    if (i == 9) {
      EXPECT_GT(std::sqrt(result.camera.covariance[0]), 0.5) << "the place before was guessed";
    }
    if (i > 9) {
      EXPECT_EQ(result.camera.status, CameraStatus::Tracked);
      EXPECT_LT(off.norm(), 0.01);
    }
    expect_parked(film, result, i);
  }
}

// A wall and a thing of which no depth is known at first: where it is, is not known either, and the camera's way is not
// its place.
TEST(LostCamera, APlaceThatIsNotKnownStaysUnknown) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0, 0, -10});  // backwards, by a metre a frame
  film.spoil = [](int i, Rendering& seen) {
    seen.ids.fill(0);
    // The second rectangle has three tenths of the first: too little to tell them to be one against their depths.
    const int left = i < 5 ? 100 : 130;
    for (int y = 80; y < 140; ++y)
      for (int x = left; x < left + 56; ++x) {
        seen.ids(x, y) = 9;
        if (i < 5) seen.depth(x, y) = 0;
      }
  };
  Dot<> dot = stereo_dot();
  std::uint32_t id = 0;
  for (int i = 0; i < 6; ++i) {
    const Result& result = film.next(dot);
    const ObjectResult* o = object_on(result, film.seen().ids, 9);
    ASSERT_TRUE(o) << i;
    if (i == 0) id = o->id;
    EXPECT_EQ(o->id, id) << i;
  }
}

}  // namespace
