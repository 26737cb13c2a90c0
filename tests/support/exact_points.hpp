// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/image/pyramid.hpp"
#include "dot/points/point_set.hpp"
#include "support/synthetic_scene.hpp"

namespace dot::test {

/// Points with the depth of the rendering, one every `step` pixels where accept(x, y) holds; their reference
/// intensities are those of `pyramid`, level by level. `sigma_q` is what the points claim of their depth, 1/m.
template <typename Camera, typename Accept>
PointSet exact_points(const Rendering& view, const Camera& camera, const Pyramid& pyramid, int step, Accept&& accept,
                      float sigma_q = 0) {
  PointSet points;
  points.levels = std::min(pyramid.size(), PointSet::kMaxLevels);
  const int border = 3 << (points.levels - 1);
  for (int y = border; y < view.depth.height() - border; y += step)
    for (int x = border; x < view.depth.width() - border; x += step) {
      if (!(view.depth(x, y) > 0) || !accept(x, y)) continue;
      const Vector3<double> ray = camera.unproject(Vector2<double>(x, y));
      points.push(static_cast<float>(x), static_cast<float>(y), static_cast<float>(ray.x()),
                  static_cast<float>(ray.y()), 1 / view.depth(x, y), sigma_q);
      for (int l = 0; l < points.levels; ++l) {
        const float scale = 1.f / static_cast<float>(1 << l);
        const auto at = [&](int p) { return (static_cast<float>(p) + 0.5f) * scale - 0.5f; };
        const auto k = static_cast<std::size_t>(l);
        const Sample s = sample(pyramid.levels[k], at(x), at(y));
        points.intensity[k].push_back(s.value), points.gu[k].push_back(s.gx), points.gv[k].push_back(s.gy);
      }
    }
  return points;
}

}  // namespace dot::test
