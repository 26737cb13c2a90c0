// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dot/align/aligner.hpp"

DOT_BEGIN_NAMESPACE

/// RMS distance in pixels between the projections of the points under two poses T_i_j. Only points inside the image
/// under at least one pose count, and about 40 of them are enough. Infinite if such a point is behind the camera under
/// the other pose, if there is no such point, and where the distance is certainly above `limit`.
template <typename Camera>
double pose_distance(const PointSet& points, const Camera& camera, const SE3d& a, const SE3d& b,
                     double limit = std::numeric_limits<double>::infinity()) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t n = points.u.size(), step = std::max<std::size_t>(1, n / 40), all = (n + step - 1) / step;
  const double largest_sum = limit * limit * static_cast<double>(all);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < n; i += step) {
    const Vector3<double> ray(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]), 1);
    const double q = static_cast<double>(points.q[i]);
    const Vector3<double> A = a.R * ray + q * a.t, B = b.R * ray + q * b.t;
    const bool before_a = A.z() >= 1e-3, before_b = B.z() >= 1e-3;
    const Vector2<double> p = before_a ? camera.template project<double>(A) : Vector2<double>::Constant(-1);
    const Vector2<double> r = before_b ? camera.template project<double>(B) : Vector2<double>::Constant(-1);
    if (!camera.contains(p, 0) && !camera.contains(r, 0)) continue;
    if (!before_a || !before_b) return infinity;
    sum += (p - r).squaredNorm();
    ++count;
    if (sum > largest_sum) return infinity;
  }
  return count ? std::sqrt(sum / count) : infinity;
}

/// Whether pose_distance is less than so many pixels. Most poses are far apart, which a few points tell.
template <typename Camera>
bool is_near(const PointSet& points, const Camera& camera, const SE3d& a, const SE3d& b, double pixels) {
  return pose_distance(points, camera, a, b, pixels) < pixels;
}

DOT_END_NAMESPACE
