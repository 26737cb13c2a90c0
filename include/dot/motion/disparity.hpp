// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "dot/camera/concept.hpp"
#include "dot/lie/se3.hpp"
#include "dot/points/point_set.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Dynamic disparity (paper, section 3.5, eq. 6): how far the object's own motion moved its points in the image.
struct DynamicDisparity {
  double median_px = 0;  ///< d_d: median distance between a point moved by T_c and by T_c T_o
  double noise_px = 0;   ///< RMS over the points of sqrt(trace(G Sigma_x G')), G = d pixel / d x
};

/// @param centroid of the object, reference camera axes; @param sigma of the twist of T_o about the moved centroid.
template <typename Camera>
DynamicDisparity dynamic_disparity(const PointSet& points, const Camera& camera, const SE3d& T_c, const SE3d& T_o,
                                   const Vector3<double>& centroid, const Matrix6<double>& sigma) {
  DynamicDisparity out;
  std::array<double, 128> distances;  // so many points are enough
  std::size_t n = 0;
  double noise = 0;
  const Vector3<double> c = T_o * centroid;
  const std::size_t step = std::max<std::size_t>(1, (points.u.size() + distances.size() - 1) / distances.size());
  for (std::size_t i = 0; i < points.u.size(); i += step) {
    if (!(points.q[i] > 0)) continue;
    const double z = 1 / static_cast<double>(points.q[i]);
    const Vector3<double> X(points.x[i] * z, points.y[i] * z, z);
    const Vector3<double> still = T_c * X, in_reference = T_o * X, moved = T_c * in_reference;
    if (still.z() < 1e-3 || moved.z() < 1e-3) continue;
    Eigen::Matrix<double, 2, 3> J;
    const Vector2<double> p = camera.template project<double>(moved, &J);
    distances[n++] = (p - camera.template project<double>(still)).norm();
    Eigen::Matrix<double, 3, 6> by_x;
    by_x << Matrix3<double>::Identity(), -so3::hat(Vector3<double>(in_reference - c));
    const Eigen::Matrix<double, 2, 6> G = J * T_c.R * by_x;
    noise += (G * sigma * G.transpose()).trace();
  }
  if (n == 0) return out;
  out.median_px = median(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(n));
  out.noise_px = std::sqrt(std::max(0.0, noise / static_cast<double>(n)));
  return out;
}

DOT_END_NAMESPACE
