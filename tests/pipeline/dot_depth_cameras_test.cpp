// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Depth cameras in a room: structured light, which sees nothing beside near things and fattens their edges, and time of
// flight, whose pixels at edges lie between both surfaces. Both are wrong in another way in each frame.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "dot/dot.hpp"
#include "support/depth_cameras.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Dot;
using dot::ObjectResult;
using dot::Options;
using dot::Pinhole;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t stands = 1, pushed = 2;
constexpr double kFocalBaseline = 200 * 0.075;

using Sensor = std::function<void(Rendering&, Random&)>;

void time_of_flight(Rendering& seen, Random& random) { see_by_time_of_flight(seen, random); }
void time_of_flight_of_few_pixels(Rendering& seen, Random& random) { see_by_time_of_flight(seen, random, 2); }
void structured_light(Rendering& seen, Random& random) { see_by_structured_light(seen, random, kFocalBaseline); }

/// A room 3 m wide whose far wall is 3.5 m ahead, with two posts 1.2 and 2 m ahead that have no mask.
std::vector<Body> room() {
  using V = Vector3<double>;
  unsigned seed = 300;
  const auto texture = [&] { return Texture(++seed, 0.12, 1.2); };
  Body walls;
  walls.quads.push_back({V(0, 0, 3.5), V(2, 0, 0), V(0, 1.2, 0), texture()});
  for (const double side : {-1.0, 1.0}) {
    walls.quads.push_back({V(1.5 * side, 0, 1.5), V(0, 0, 2.2), V(0, 1.2, 0), texture()});
    walls.quads.push_back({V(0, 1.2 * side, 1.5), V(1.6, 0, 0), V(0, 0, 2.2), texture()});
  }
  Body near = box(0, {0.04, 1, 0.04}, seed += 10, 0.05, 0.5), far = box(0, {0.06, 1, 0.06}, seed += 10, 0.08, 0.5);
  near.T_world_body.t = {0.1, 0, 1.2};
  far.T_world_body.t = {-0.9, 0, 2};
  return {walls, near, far};
}

/// A hand-held camera at 30 Hz before a box that stands and one that is pushed at .15 m/s.
Film<> in_a_room(const Sensor& sensor, double speed = 0.15) {
  Film<> film;
  film.interval = 1.0 / 30;
  film.camera_path = [](double t) {
    const Vector3<double> turn(0.03 * std::sin(5 * t), 0.1 * std::sin(3 * t), 0);
    return SE3d{dot::so3::exp(turn), Vector3<double>(0.15 * std::sin(2 * t), 0.03 * std::sin(4 * t), 0.1 * t)};
  };
  film.degradation.noise = 1.5;
  film.add(box(stands, {0.15, 0.2, 0.12}, 500, 0.06, 0.4), straight({0.6, 0.2, 1.7}));
  film.add(box(pushed, {0.15, 0.2, 0.12}, 600, 0.06, 0.4), straight({-0.6, 0.2, 1.6}, {speed, 0, 0}));
  film.direct = [](int i, Scene& scene) {
    if (i > 0) return;
    scene.bodies.erase(scene.bodies.begin());  // the yard
    for (const Body& body : room()) scene.bodies.push_back(body);
  };
  film.spoil = [sensor](int i, Rendering& seen) {
    Random random(static_cast<unsigned>(77 + i));
    sensor(seen, random);
  };
  return film;
}

Dot<> make_dot(bool discover = false) {
  Options options;
  options.depth_noise.source = dot::DepthSource::Rgbd;
  options.discover_unknown = discover;
  Pinhole camera(small_camera());
  return Dot<>(camera, options);
}

/// A network's masks reach beyond their objects: there is an edge of depth in each of them.
void expect_tells_them_apart(const Sensor& sensor) {
  Film<> film = in_a_room(sensor);
  film.degradation.leak = 3;
  Dot<> dot = make_dot();
  for (int i = 0; i < 24; ++i) {
    const Result& result = film.next(dot);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> T(result.camera.T_cur_prev.data());
    EXPECT_LT((T.col(3) - film.T_c().t).norm(), 0.0012) << i;
    const ObjectResult *still = object_on(result, film.truth().ids, stands),
                       *moves = object_on(result, film.truth().ids, pushed);
    ASSERT_TRUE(still && moves) << i;
    EXPECT_NE(still->state, State::Moving) << i << ": " << describe(still);
    if (i < 15) continue;
    EXPECT_EQ(still->state, State::Static) << i << ": " << describe(still);
    EXPECT_EQ(moves->state, State::Moving) << i << ": " << describe(moves);
    EXPECT_NEAR(moves->fused_velocity[0], 0.15, 0.05) << i;
  }
}

TEST(DepthCameras, TimeOfFlight) { expect_tells_them_apart(time_of_flight); }
TEST(DepthCameras, TimeOfFlightOfFewPixels) { expect_tells_them_apart(time_of_flight_of_few_pixels); }
TEST(DepthCameras, StructuredLight) { expect_tells_them_apart(structured_light); }

/// Without masks, before things that stand.
void expect_discovers_nothing(const Sensor& sensor) {
  Film<> film = in_a_room(sensor, 0);
  film.edit = [](int, dot::Frame& frame) { frame.masks = dot::Masks{}; };
  Dot<> dot = make_dot(true);
  for (int i = 0; i < 25; ++i) {
    const Result& result = film.next(dot);
    EXPECT_EQ(result.objects.size, 0u) << i << ": " << describe(result.objects.data);
  }
}

TEST(DepthCameras, NothingIsDiscoveredByTimeOfFlight) { expect_discovers_nothing(time_of_flight_of_few_pixels); }
TEST(DepthCameras, NothingIsDiscoveredByStructuredLight) { expect_discovers_nothing(structured_light); }

void expect_discovers_what_is_pushed(const Sensor& sensor) {
  Film<> film = in_a_room(sensor, 0.4);
  film.edit = [](int, dot::Frame& frame) { frame.masks = dot::Masks{}; };
  Dot<> dot = make_dot(true);
  int found = 0;
  for (int i = 0; i < 25; ++i) {
    const Result& result = film.next(dot);
    const ObjectResult* moves = object_on(result, film.truth().ids, pushed);
    found += moves && moves->state == State::Moving;
  }
  EXPECT_GT(found, 8);
}

TEST(DepthCameras, WhatIsPushedIsDiscoveredByTimeOfFlight) { expect_discovers_what_is_pushed(time_of_flight); }
TEST(DepthCameras, WhatIsPushedIsDiscoveredByStructuredLight) { expect_discovers_what_is_pushed(structured_light); }

/// A camera that stands, at 60 Hz: nothing moves, however the edges flicker.
void expect_all_stands(const Sensor& sensor) {
  Film<> film = in_a_room(sensor, 0);
  film.interval = 1.0 / 60;
  film.camera_path = straight({0, 0, 0});
  film.degradation.leak = 3;
  Dot<> dot = make_dot(true);
  for (int i = 0; i < 30; ++i) {
    const Result& result = film.next(dot);
    ASSERT_EQ(result.objects.size, 2u) << i;
    for (std::size_t k = 0; k < 2; ++k) {
      const State expected =
          i < 25 && result.objects[k].state == State::NotObservable ? State::NotObservable : State::Static;
      EXPECT_EQ(result.objects[k].state, expected) << i << ": " << describe(&result.objects[k]);
    }
  }
}

TEST(DepthCameras, AllStandsBeforeTimeOfFlight) { expect_all_stands(time_of_flight); }
TEST(DepthCameras, AllStandsBeforeStructuredLight) { expect_all_stands(structured_light); }

}  // namespace
