// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "support/synthetic_scene.hpp"

namespace dot::bench {

/// A furnished room 3 m wide, 2.4 m high, whose far wall is 3.5 m ahead of the world's origin: textured walls, floor
/// and ceiling, and boxes in front of them. `shortest` is the shortest wavelength of the textures, metres.
inline test::Scene room(unsigned seed, double shortest = 0.06) {
  using V = Vector3<double>;
  const auto texture = [&] { return test::Texture(++seed, shortest, 1.2); };
  test::Body walls;
  walls.quads.push_back({V(0, 0, 3.5), V(1.5, 0, 0), V(0, 1.2, 0), texture()});
  for (const double side : {-1.0, 1.0}) {
    walls.quads.push_back({V(1.5 * side, 0, 1.5), V(0, 0, 2), V(0, 1.2, 0), texture()});
    walls.quads.push_back({V(0, 1.2 * side, 1.5), V(1.5, 0, 0), V(0, 0, 2), texture()});
  }
  test::Scene scene;
  scene.bodies.push_back(walls);
  test::Random random(seed);
  for (int i = 0; i < 5; ++i) {
    const V half(random.uniform(0.15, 0.35), random.uniform(0.15, 0.4), random.uniform(0.15, 0.3));
    test::Body furniture = test::box(0, half, seed += 10, shortest, 1.2);
    furniture.T_world_body.R = so3::exp(V(0, random.uniform(-0.8, 0.8), 0));
    furniture.T_world_body.t = V(-1.1 + 0.55 * i, random.uniform(0.4, 0.9), random.uniform(2, 3));
    scene.bodies.push_back(furniture);
  }
  return scene;
}

/// Two views of a room as a sensor gives them, and the camera's motion between them.
struct Pair {
  test::Rendering reference, current;
  SE3d T_cur_ref;
};

/// A camera of 63 degrees.
inline Pinhole camera_of(int width, int height) {
  const double f = 0.8125 * width;
  return Pinhole({f, f, 0.5 * (width - 1), 0.5 * (height - 1), width, height, 0});
}

/// A step of 5 to 30 mm and 0.5 to 2 degrees in a random direction about a random axis. Each pixel has noise of 2 grey
/// values and, as structured light has at 2 m, of 3 mm depth (0.0008 1/m).
inline Pair room_pair(unsigned seed, const Pinhole& camera) {
  test::Random random(seed);
  const Vector3<double> direction = random.normal3().normalized(), axis = random.normal3().normalized();
  Vector6<double> twist;
  twist << direction * random.uniform(0.005, 0.03), axis * random.uniform(0.5, 2) * 3.14159265358979 / 180;
  const test::Scene scene = room(1000 * seed, 0.06 * 520 / camera.intrinsics().fx);
  Pair pair;
  pair.T_cur_ref = SE3d::exp(twist);
  test::Degradation sensor;
  sensor.noise = 2, sensor.depth_noise = 0.0008, sensor.seed = 2 * seed;
  pair.reference = degraded(scene.render(camera, SE3d{}), sensor);
  ++sensor.seed;
  pair.current = degraded(scene.render(camera, pair.T_cur_ref.inverse()), sensor);
  return pair;
}

}  // namespace dot::bench
