// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/camera/concept.hpp"
#include "dot/mask/mask.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Step of rows and columns that leaves 1000 or more samples of a mask of `area` pixels. These are enough for its
/// middle and its depth.
inline int sampling_step(int area) { return std::max(1, static_cast<int>(std::sqrt(area / 1000.0))); }

/// Centre of a mask at its median depth, metres, axes of its frame's camera. Zero if it has no depth.
/// @param inverse_depth 1/m, <= 0: not measured. @param values scratch.
template <typename Camera>
Vector3<double> centre_of(const Mask& mask, const Image<float>& inverse_depth, const Camera& camera,
                          std::vector<float>& values) {
  constexpr std::size_t kEnough = 10;  // samples with depth
  values.clear();
  double u = 0, v = 0;
  int n = 0;
  const int step = sampling_step(mask.area);
  for (int y = 0; y < mask.height(); y += step)
    for (int x = 0; x < mask.width(); x += step) {
      if (!mask.pixels(x, y)) continue;
      u += mask.x + x;
      v += mask.y + y;
      ++n;
      const float value = inverse_depth(mask.x + x, mask.y + y);
      if (value > 0) values.push_back(value);
    }
  if (values.size() < kEnough) return Vector3<double>::Zero();
  const double q = static_cast<double>(median(values.begin(), values.end()));
  return camera.template unproject<double>(Vector2<double>(u / n, v / n)) / q;
}

DOT_END_NAMESPACE
