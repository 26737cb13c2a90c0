// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The depth of a network is complete: the sky has about the largest depth that the network knows. A camera that drives
// fast must not be held by it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "dot/tracker.hpp"
#include "support/film.hpp"
#include "support/random.hpp"

namespace {

using dot::CameraStatus;
using dot::Result;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

constexpr double kSpeed = 25;    // m/s
constexpr double kLargest = 80;  // metres

/// A road with a dull surface under a sky full of clouds.
Film<> motorway() {
  Film<> film;
  film.camera_path = straight(Vector3<double>::Zero(), {0, 0, kSpeed});
  film.degradation.noise = 1;
  film.direct = [](int i, Scene& scene) {
    if (i > 0) {
      scene.bodies[0].quads[1].centre.z() += 0.1 * kSpeed;
      return;
    }
    using V = Vector3<double>;
    scene.bodies[0].quads = {{V(0, 2, 200), V(60, 0, 0), V(0, 0, 300), Texture(7, 1.2, 9, 12)},
                             {V(0, -2000, 2000), V(4000, 0, 0), V(0, 2000, 0), Texture(8, 150, 900)}};
  };
  film.spoil = [](int, Rendering& seen) {
    Random random(9);
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x) {
        float& z = seen.depth(x, y);
        z = std::min(z, static_cast<float>(kLargest * (1 - 0.03 * random.uniform())));
      }
  };
  return film;
}

TEST(DotFarPile, ASkyWithDepthDoesNotHoldTheCamera) {
  Film<> film = motorway();
  dot::Tracker tracker(small_camera(), {});
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(tracker);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked) << i;
    EXPECT_NEAR(result.camera.T_cur_prev[11], -0.1 * kSpeed, 0.03) << i;
  }
}

}  // namespace
