// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "support/random.hpp"
#include "support/synthetic_scene.hpp"

/// @file
/// What the depth cameras of indoor robots make of the exact depth of a rendering.

namespace dot::test {

/// The nearest and the farthest depth within some columns and rows of each pixel.
struct DepthAround {
  Image<float> nearest, farthest;

  DepthAround(const Image<float>& depth, int reach) {
    nearest = farthest = depth;
    for (int y = 0; y < depth.height(); ++y)
      for (int x = 0; x < depth.width(); ++x)
        for (int v = std::max(0, y - reach); v <= std::min(depth.height() - 1, y + reach); ++v)
          for (int u = std::max(0, x - reach); u <= std::min(depth.width() - 1, x + reach); ++u) {
            if (!(depth(u, v) > 0)) continue;
            nearest(x, y) = std::min(nearest(x, y), depth(u, v));
            farthest(x, y) = std::max(farthest(x, y), depth(u, v));
          }
  }
  /// Whether two surfaces meet there, one behind the other.
  bool is_edge(int x, int y) const { return farthest(x, y) > 1.12f * nearest(x, y); }
};

/// Time of flight: most pixels at an edge of depth see both surfaces, and take a depth anywhere between them, another
/// one in each frame. Noise of 2 mm at a metre, which grows with the distance.
inline void see_by_time_of_flight(Rendering& seen, Random& random, int reach = 1) {
  const DepthAround around(seen.depth, reach);
  for (int y = 0; y < seen.depth.height(); ++y)
    for (int x = 0; x < seen.depth.width(); ++x) {
      float& z = seen.depth(x, y);
      const double share = random.uniform(), noise = random.normal(0.002), mixed = random.uniform();
      if (around.is_edge(x, y) && mixed < 0.8)
        z = around.nearest(x, y) + static_cast<float>(share) * (around.farthest(x, y) - around.nearest(x, y));
      z += static_cast<float>(noise) * z * z;
    }
}

/// Structured light, with the projector to the right of the camera. Pixels that a nearer surface hides from the
/// projector have no depth: a band on the left of near things. Nearer surfaces reach up to three pixels too far, in
/// patches of four pixels that are others in each frame. Disparities come in steps of an eighth of a pixel.
/// @param focal_baseline pixel metres: focal length times the distance between projector and camera.
inline void see_by_structured_light(Rendering& seen, Random& random, double focal_baseline) {
  constexpr int kPatch = 4;
  const Image<float> exact = seen.depth;
  const std::array<DepthAround, 2> around{DepthAround(exact, 2), DepthAround(exact, 3)};
  Image<int> reach(exact.width() / kPatch + 1, exact.height() / kPatch + 1);
  for (int y = 0; y < reach.height(); ++y)
    for (int x = 0; x < reach.width(); ++x) reach(x, y) = static_cast<int>(random.uniform(0, 3));  // 0: none
  for (int y = 0; y < exact.height(); ++y) {
    double leftmost = 1e9;  // column of the projector that the surfaces to the right of the pixel reach
    for (int x = exact.width() - 1; x >= 0; --x) {
      const int fat = reach(x / kPatch, y / kPatch);
      float z = exact(x, y);
      if (fat > 0 && around[static_cast<std::size_t>(fat - 1)].is_edge(x, y))
        z = around[static_cast<std::size_t>(fat - 1)].nearest(x, y);
      const double disparity = focal_baseline / static_cast<double>(z), column = x - disparity;
      const double measured = std::round(8 * (disparity + random.normal(0.06))) / 8;
      seen.depth(x, y) = column < leftmost + 0.5 && measured > 0 ? static_cast<float>(focal_baseline / measured) : 0.f;
      leftmost = std::min(leftmost, column);
    }
  }
}

}  // namespace dot::test
