// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "dot/align/aligner.hpp"

DOT_BEGIN_NAMESPACE

/// RMS distance in pixels between the places in the image under two poses T_i_j of the points that are in it under at
/// least one. Of many points some 40 tell. Infinite where such a point is behind the camera under the other pose, or
/// where there is none.
template <typename Camera>
double pose_distance(const PointSet& points, const Camera& camera, const SE3d& a, const SE3d& b) {
  const std::size_t n = points.u.size(), step = std::max<std::size_t>(1, n / 40);
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
    if (!before_a || !before_b) return std::numeric_limits<double>::infinity();
    sum += (p - r).squaredNorm();
    ++count;
  }
  return count ? std::sqrt(sum / count) : std::numeric_limits<double>::infinity();
}

/// Local minima found from several starts: those that lead to the same one, within `kSamePixels`, are one.
struct Minima {
  static constexpr double kSamePixels = 0.1;
  std::vector<Alignment> found;

  /// Drops those for which `condition` holds, unless it holds for all.
  template <typename Condition>
  void drop_if(Condition&& condition) {
    if (!std::all_of(found.begin(), found.end(), condition))
      found.erase(std::remove_if(found.begin(), found.end(), condition), found.end());
  }
  /// @return whether it was a new one.
  template <typename Camera>
  bool add(const AlignProblem<Camera>& problem, const Alignment& a) {
    for (const Alignment& other : found)
      if (pose_distance(problem.points, problem.camera, a.state.T, other.state.T) < kSamePixels) return false;
    found.push_back(a);
    return true;
  }
};

/// Buffers of the estimators that look for such minima.
struct MinimaWorkspace {
  Minima minima;
  std::vector<AlignState> starts;
  std::vector<std::pair<double, SE3d>> tried, turns;   ///< places with their costs
  std::vector<std::pair<double, AlignState>> shifted;  ///< likewise
  std::vector<std::pair<double, std::size_t>> ranked;  ///< costs of the minima
  std::vector<Alignment> kept;
  std::vector<float> depths;
  PointSet distant;  ///< points at infinity
};

DOT_END_NAMESPACE
