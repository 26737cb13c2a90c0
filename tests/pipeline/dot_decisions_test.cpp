// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// When a state must change, at any frame rate, and what a large mover or a frame without depth may not spoil.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Frame;
using dot::ObjectResult;
using dot::Options;
using dot::Reason;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Tracker;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr std::uint32_t parked = 1, mover = 3;
const Vector3<double> origin = Vector3<double>::Zero();

/// A path at `speed`, m/s, along x, that from `start` on brakes until it stands.
Path braking(const Vector3<double>& from, double start, double deceleration, double speed) {
  return [=](double t) {
    const double since = std::clamp(t - start, 0.0, speed / deceleration);
    const double way = speed * std::min(t, start) + speed * since - 0.5 * deceleration * since * since;
    return SE3d::translation(Vector3<double>(from + Vector3<double>(way, 0, 0)));
  };
}

/// What counts as moving at this range, m/s.
double v0(double range) { return dot::VelocitySettings{}.v0_at(range); }

/// A camera that drives slowly, with the noise of a usual sensor.
Film<> film_at(double fps) {
  Film<> film;
  film.interval = 1 / fps;
  film.camera_path = straight(origin, {0, 0, 0.5});
  film.degradation.noise = 1.5;
  film.degradation.depth_noise = 0.1 / 40;
  return film;
}

Tracker stereo_tracker() {
  Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  return Tracker(small_camera(), options);
}

class FrameRate : public testing::TestWithParam<double> {};

TEST_P(FrameRate, ACarThatStopsIsStaticWithinASecond) {
  Film<> film = film_at(GetParam());
  const double start = 0.6, deceleration = 3, speed = 2;
  film.add(mover, braking({-2.6, 1.3, 7}, start, deceleration, speed));
  const double slow = start + (speed - v0(6.3) / 2) / deceleration;  // its front is 0.7 m nearer than its centre
  Tracker tracker = stereo_tracker();
  for (int i = 0; film.interval * i < slow + 1.25; ++i) {
    const double t = film.interval * i;
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(t) + " s: " + describe(o));
    ASSERT_TRUE(o);
    if (t > 0.5 && t < start + 0.01) {
      EXPECT_EQ(o->state, State::Moving);
    }
    if (t < slow) {
      EXPECT_NE(o->state, State::Static);
    }
    if (t >= slow + 1) {
      EXPECT_EQ(o->state, State::Static);
    }
  }
}

TEST_P(FrameRate, AParkedCarThatDrivesOffIsMovingTwoFramesAfterTwiceV0) {
  Film<> film = film_at(GetParam());
  const double start = 0.6, acceleration = 1.5;
  film.add(mover, departing({-2, 1.3, 7}, start, acceleration, 2));
  const double fast = start + 2 * v0(6.3) / acceleration;
  const double flipped = fast + 1.5 / GetParam();  // the frame after the first that lies wholly beyond
  Tracker tracker = stereo_tracker();
  for (int i = 0; film.interval * i < fast + 0.75; ++i) {
    const double t = film.interval * i;
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(t) + " s: " + describe(o));
    ASSERT_TRUE(o);
    if (t > 0.5 && t < start + 0.01) {
      EXPECT_EQ(o->state, State::Static);
    }
    if (t < start + 0.01) {
      EXPECT_NE(o->state, State::Moving);
    }
    if (t >= flipped) {
      EXPECT_EQ(o->state, State::Moving);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Decision, FrameRate, testing::Values(5.0, 10.0, 30.0),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param)) + "Hz"; });

/// A box of 0.3 m on a table, 1.3 m before an RGB-D camera in a hand.
constexpr std::uint32_t box_on_table = 5;
const Vector3<double> on_table(0.1, 0.05, 1.3);
Film<> table(const Path& path, double depth = 0.15) {
  Film<> film;
  film.camera_path = [](double t) {
    return SE3d{dot::so3::exp(Vector3<double>(0, 0.05 * std::sin(2 * t), 0)), Vector3<double>(0.04 * t, 0, 0)};
  };
  film.degradation.noise = 1.5;
  film.degradation.depth_noise = 0.002;
  film.direct = [](int i, Scene& scene) {
    if (i > 0) return;
    using V = Vector3<double>;
    Body& room = scene.bodies.front();
    room.quads.clear();
    room.quads.push_back({V(0, 0.25, 1.5), V(6, 0, 0), V(0, 0, 3), Texture(11, 0.06, 0.5)});  // the table
    room.quads.push_back({V(0, -1, 2.6), V(6, 0, 0), V(0, 3, 0), Texture(12, 0.08, 0.6)});    // a wall
  };
  film.add(box(box_on_table, {0.15, 0.15, depth}, 77, 0.03, 0.2), path);
  return film;
}

/// States of the box after the first half second, at `fps`.
std::vector<State> states_on_table(const Path& path, double fps, double seconds = 1.5, double depth = 0.15) {
  Film<> film = table(path, depth);
  film.interval = 1 / fps;
  Options options;
  options.depth_noise.source = dot::DepthSource::Rgbd;
  Tracker tracker(small_camera(), options);
  std::vector<State> states;
  for (int i = 0; film.interval * i < seconds; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, box_on_table);
    if (film.interval * i >= 0.5) states.push_back(o ? o->state : State::Background);
  }
  return states;
}
double share(const std::vector<State>& states, State state) {
  return static_cast<double>(std::count(states.begin(), states.end(), state)) / static_cast<double>(states.size());
}
Path turning(double degrees_per_second) {
  return [=](double t) { return SE3d{dot::so3::exp(Vector3<double>(0, degrees_per_second * t / 57.3, 0)), on_table}; };
}

TEST_P(FrameRate, ASlowBoxOnATableMoves) {
  EXPECT_GE(share(states_on_table(straight(on_table, {0.06, 0, 0}), GetParam()), State::Moving), 0.9);
}

TEST_P(FrameRate, ABoxThatTurnsOnTheSpotMoves) {
  EXPECT_GE(share(states_on_table(turning(20), GetParam()), State::Moving), 0.9);
}

// The centroid of a board that faces the camera stays where it is.
TEST_P(FrameRate, ABoardThatTurnsLikeAWheelMoves) {
  const Path wheel = [](double t) { return SE3d{dot::so3::exp(Vector3<double>(0, 0, 0.35 * t)), on_table}; };
  EXPECT_GE(share(states_on_table(wheel, GetParam(), 1.5, 0.01), State::Moving), 0.9);
}

TEST_P(FrameRate, ABoxAtRestOnATableIsStatic) {
  EXPECT_GE(share(states_on_table(straight(on_table), GetParam(), 3), State::Static), 0.95);
}

/// A yard of little contrast and, close to the camera, something large of much.
Film<> lorry(const Vector3<double>& velocity) {
  Film<> film = film_at(10);
  film.camera_path = straight(origin, {0.3, 0, 1});
  film.add(mover, straight(Vector3<double>(-0.6, 0.1, 4.2) - 0.4 * velocity, velocity));
  film.degradation.noise = 1;
  film.direct = [](int i, Scene& scene) {
    if (i > 0) return;
    for (Body& body : scene.bodies) {
      if (body.id == mover)
        body.quads = box(mover, {1.7, 1.3, 0.6}, 4000, 0.15, 1.2).quads;
      else
        for (Quad& quad : body.quads) quad.texture = Texture(100, 0.8, 5, 10);
    }
  };
  return film;
}

/// Shares of a body: of the pixels, and of the squared gradients.
struct Share {
  double pixels = 0, texture = 0;

  Share(const Rendering& view, std::uint32_t id) {
    double n = 0, sum = 0;
    for (int y = 1; y < view.ids.height() - 1; ++y)
      for (int x = 1; x < view.ids.width() - 1; ++x) {
        const float gx = view.intensity(x + 1, y) - view.intensity(x - 1, y);
        const float gy = view.intensity(x, y + 1) - view.intensity(x, y - 1);
        const double g = static_cast<double>(gx * gx + gy * gy);
        n += 1, sum += g;
        if (view.ids(x, y) == id) pixels += 1, texture += g;
      }
    pixels /= n, texture /= sum;
  }
};

// The mover goes 12 or 15 cm a frame, and a camera that follows it is that far off. Bounds: a centimetre, at 10 Hz a
// fifth of v0, or 5 % of the way; a turn by which things 10 m away shift as much.
TEST(LargeMover, DoesNotCaptureTheCamera) {
  for (const Vector3<double>& velocity : {Vector3<double>(1.2, 0, 0), Vector3<double>(0, 0, 1.5)}) {
    SCOPED_TRACE("vx " + std::to_string(velocity.x()));
    Film<> film = lorry(velocity);
    Tracker tracker = stereo_tracker();
    for (int i = 0; i < 9; ++i) {
      const Result& result = film.next(tracker);
      SCOPED_TRACE(i);
      const Share share(film.truth(), mover);
      ASSERT_GT(share.pixels, 1.0 / 3);
      ASSERT_GT(share.texture, 0.8);
      if (i == 0) continue;
      ASSERT_EQ(result.camera.status, CameraStatus::Tracked);
      const Vector6<double> e = (SE3d::from_row_major(result.camera.T_cur_prev) * film.T_c().inverse()).log();
      EXPECT_LT(e.head<3>().norm(), std::max(0.01, 0.05 * film.T_c().t.norm()));
      EXPECT_LT(e.tail<3>().norm(), 0.001);
      const ObjectResult* o = object_on(result, film.truth().ids, mover);
      ASSERT_TRUE(o);
      if (i >= 5) {
        EXPECT_EQ(o->state, State::Moving) << describe(o);
      }
    }
  }
}

// The frame after one in which the object has no depth is compared with the last in which it had.
TEST(NoDepthForAFrame, TheNextStillTellsTheMotion) {
  const int blind = 5;
  Film<> film = film_at(10);
  film.add(mover, straight({-2, 1.3, 7}, {1.5, 0, 0.5}));
  film.spoil = [](int i, Rendering& seen) {
    if (i != blind) return;
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == mover) seen.depth(x, y) = 0;
  };
  Tracker tracker = stereo_tracker();
  for (int i = 0; i <= blind + 2; ++i) {
    const Result& result = film.next(tracker);
    if (i < 2) continue;
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    ASSERT_EQ(o->reason, Reason::None);
    EXPECT_NEAR(o->interval, i == blind + 1 ? 0.2 : 0.1, kClockError);
    const Eigen::Map<const Vector3<double>> velocity(o->velocity.data());
    const Eigen::Map<const dot::Matrix3<double>> V(o->velocity_covariance.data());
    const Vector3<double> before = film.before(mover);
    const Vector3<double> truth = (film.T_o(mover) * before - before) / 0.1;
    const Vector3<double> e = velocity - truth;
    EXPECT_LT(e.dot(V.ldlt().solve(e)), 11.3);  // 99 %
    EXPECT_LT(std::sqrt(V.trace()), 0.3);       // and that is a fifth of its speed
    EXPECT_NEAR(o->speed, velocity.norm(), 1e-9);
    // T_o tells the same of the car's centre, though that is not the centroid of the points.
    const Vector3<double> shift = (SE3d::from_row_major(o->T_o) * before - film.T_o(mover) * before) / 0.1;
    EXPECT_LT(shift.dot(V.ldlt().solve(shift)), 11.3);
  }
}

// The entropy rule tells no velocity after a frame without a fit: none, not that of standing still, against which the
// next fit would be refused.
TEST(NoFitForAFrame, TheNextIsNotRefused) {
  const int blind = 6;
  Film<> film = film_at(10);
  film.add(mover, straight({-3.2, 1.3, 8}, {4, 0, 0}));
  film.direct = [](int i, Scene& scene) {
    for (Body& body : scene.bodies)
      if (body.id == mover) body.quads = car(mover, i == blind ? 77000 : 1000 * mover).quads;
  };
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  options.classifier = dot::ClassifierKind::Entropy;
  Tracker tracker(small_camera(), options);
  for (int i = 0; i <= blind + 1; ++i) {
    const Result& result = film.next(tracker);
    if (i < 2) continue;
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    if (i == blind)
      EXPECT_NE(o->reason, Reason::None);
    else
      EXPECT_EQ(o->reason, Reason::None);
  }
}

// Masks begin at some frame; the pixels were in view before.
TEST(LookBack, ANewObjectIsDecidedInTheFrameOfItsFirstMask) {
  const int first = 3;
  Film<> film = film_at(10);
  film.camera_path = straight(origin, {0.3, 0, 1});
  film.add(mover, straight({-2, 1.3, 7}, {3, 0, 0.5}));
  film.add(parked, straight({2.4, 1.3, 7.5}));
  film.edit = [](int i, Frame& frame) {
    if (i < first) frame.masks.reset();
  };
  Tracker tracker = stereo_tracker();
  for (int i = 0; i < first; ++i) film.next(tracker);
  const Result& result = film.next(tracker);
  const ObjectResult* o = object_on(result, film.truth().ids, mover);
  ASSERT_TRUE(o);
  EXPECT_EQ(o->reason, Reason::None);
  EXPECT_EQ(o->state, State::Moving) << describe(o);
  EXPECT_NEAR(o->interval, 0.1, kClockError);
  const Vector3<double> before = film.before(mover);
  const Eigen::Map<const dot::Matrix3<double>> V(o->velocity_covariance.data());
  const Vector3<double> shift = (SE3d::from_row_major(o->T_o) * before - film.T_o(mover) * before) / 0.1;
  EXPECT_LT(shift.dot(V.ldlt().solve(shift)), 11.3);  // 99 %
  EXPECT_LT(std::sqrt(V.trace()), 0.6);               // a fifth of its speed
  const ObjectResult* p = object_on(result, film.truth().ids, parked);
  ASSERT_TRUE(p);
  EXPECT_EQ(p->reason, Reason::None);
  EXPECT_NE(p->state, State::Moving) << describe(p);
  const Eigen::Map<const Vector3<double>> v(p->velocity.data());
  const Eigen::Map<const dot::Matrix3<double>> Vp(p->velocity_covariance.data());
  EXPECT_LT(v.dot(Vp.ldlt().solve(v)), 11.3);
}

// In the last frame a wall hides three quarters of what the frame before has seen of it.
TEST(LookBack, WhatSlipsBehindAWallIsFollowedWhileAnythingIsSeenOfIt) {
  constexpr std::uint32_t wall = 9;
  constexpr int last = 4;
  const Vector3<double> velocity(13.5, 0, 0);
  Film<> film = film_at(10);
  film.camera_path = straight(origin);
  film.add(mover, straight({-6.2, 1.3, 8.5}, velocity));
  film.add(wall, straight({0.624, 0.7, 4.6}));
  film.direct = [](int, Scene& scene) {
    for (Body& body : scene.bodies)
      if (body.id == wall) body.quads = box(wall, {1.3, 1.3, 0.3}, 4000, 0.15, 1.2).quads;
  };
  Tracker tracker = stereo_tracker();
  int whole = 0;
  for (int i = 0; i <= last; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    if (i + 1 == last) whole = o->area;
    if (i < last) continue;
    ASSERT_LT(o->area, 0.3 * whole);
    EXPECT_EQ(o->reason, Reason::None);
    EXPECT_EQ(o->state, State::Moving);
    const Vector3<double> before = film.before(mover);
    const Eigen::Map<const dot::Matrix3<double>> V(o->velocity_covariance.data());
    const Vector3<double> error = (SE3d::from_row_major(o->T_o) * before - film.T_o(mover) * before) / film.interval;
    EXPECT_LT(error.dot(V.ldlt().solve(error)), 11.3);  // 99 %
    EXPECT_LT(error.norm(), 0.1 * velocity.norm());
  }
}

// The first frame of all, and one after a gap, have nothing to look back to.
TEST(LookBack, NeedsAnEarlierFrame) {
  Film<> film = film_at(10);
  film.add(mover, straight({-2, 1.3, 7}, {3, 0, 0.5}));
  Tracker tracker = stereo_tracker();
  const ObjectResult* o = object_on(film.next(tracker), film.truth().ids, mover);
  ASSERT_TRUE(o);
  EXPECT_EQ(o->reason, Reason::New);
}

// Two cars that look alike: one is seen in the first frame alone, the other only later, 4.5 m beside it. In a noisy
// view one seems to be the other, at 45 m/s.
TEST(FirstFit, ACarThatResemblesAnotherIsNotMoving) {
  constexpr std::uint32_t gone = 1, stands = 2;
  constexpr unsigned seed = 1000;
  const Vector3<double> out_of_sight(0, 0, -20);
  const auto seen = [&](double x, bool in_first) {
    return
        [=](double t) { return SE3d::translation((t < 0.05) == in_first ? Vector3<double>(x, 1.3, 8) : out_of_sight); };
  };
  Film<> film = film_at(10);
  film.degradation.noise = 11;
  film.add(car(gone, seed), seen(-2.5, true));
  film.add(car(stands, seed), seen(2, false));
  Tracker tracker = stereo_tracker();
  for (int i = 0; i < 4; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) continue;
    const ObjectResult* o = object_on(result, film.truth().ids, stands);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    EXPECT_NE(o->state, State::Moving);
    if (i == 3) {
      EXPECT_EQ(o->state, State::Static);
    }
  }
}

// In a noisy view every fit correlates badly. What is faster than the search expects is told from the second fit on.
TEST(FirstFit, AFastCarInANoisyViewIsMovingOnceTwoFitsAgree) {
  Film<> film = film_at(30);
  film.degradation.noise = 13;
  film.add(mover, straight({-5.5, 1.3, 8}, {36, 0, 0}));
  Tracker tracker = stereo_tracker();
  for (int i = 0; i < 7; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    if (i > 0 && i < 3) {
      EXPECT_LT(o->phi, 0.95);  // or the scene is too easy
    }
    EXPECT_NE(o->state, State::Static);
    if (i >= 4) {
      EXPECT_EQ(o->state, State::Moving);
    }
  }
}

// Beside a camera at 12 m/s, nearly as fast: where it would be if it stood is out of the image in the next frame.
TEST(Alongside, AtTheCamerasSpeedIsFollowedFromTheFirstFrame) {
  Film<> film = film_at(10);
  film.camera_path = straight(origin, {0, 0, 12});
  film.add(mover, straight({-1.6, 1.3, 2.6}, {0, 0, 12.5}));
  film.edit = [](int i, Frame& frame) {
    if (i > 0) frame.masks.reset();
  };
  Tracker tracker = stereo_tracker();
  std::uint32_t id = 0;
  for (int i = 0; i < 4; ++i) {
    const Result& result = film.next(tracker);
    const ObjectResult* o = object_on(result, film.truth().ids, mover);
    SCOPED_TRACE(std::to_string(i) + ": " + describe(o));
    ASSERT_TRUE(o);
    if (i == 0) id = o->id;
    EXPECT_EQ(o->id, id);
    if (i == 0) continue;
    EXPECT_EQ(o->reason, Reason::None);
    const Vector3<double> before = film.before(mover);
    const Vector3<double> shift = SE3d::from_row_major(o->T_o) * before - film.T_o(mover) * before;
    EXPECT_LT(shift.norm(), 0.1 * 1.25);
  }
}

}  // namespace
