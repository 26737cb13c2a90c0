// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dot/align/aligner.hpp"

DOT_BEGIN_NAMESPACE

/// RMS distance in pixels between the points' places in the image under two poses T_i_j. Of many points some 40 tell.
/// Infinite where a point comes to lie behind the camera.
template <typename Camera>
double pose_distance(const PointSet& points, const Camera& camera, const SE3d& a, const SE3d& b) {
  const std::size_t n = points.u.size(), step = std::max<std::size_t>(1, n / 40);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < n; i += step) {
    const Vector3<double> ray(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]), 1);
    const double q = static_cast<double>(points.q[i]);
    const Vector3<double> A = a.R * ray + q * a.t, B = b.R * ray + q * b.t;
    if (A.z() < 1e-3 || B.z() < 1e-3) return std::numeric_limits<double>::infinity();
    sum += (camera.template project<double>(A) - camera.template project<double>(B)).squaredNorm();
    ++count;
  }
  return count ? std::sqrt(sum / count) : 0;
}

/// Local minima found from several starts: those that lead to the same one, within `kSamePixels`, are one.
struct Minima {
  static constexpr double kSamePixels = 0.1;
  std::vector<Alignment> found;

  /// @return whether it was a new one.
  template <typename Camera>
  bool add(const AlignProblem<Camera>& problem, const Alignment& a) {
    for (const Alignment& other : found)
      if (pose_distance(problem.points, problem.camera, a.state.T, other.state.T) < kSamePixels) return false;
    found.push_back(a);
    return true;
  }
};

DOT_END_NAMESPACE
