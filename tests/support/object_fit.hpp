// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/lie/se3.hpp"
#include "support/random.hpp"

namespace dot::test {

constexpr double dt = 0.1;  // seconds

inline SE3d pose(const Vector3<double>& rotation, const Vector3<double>& place) { return {so3::exp(rotation), place}; }

/// A camera that drives and turns, T_world_camera after n intervals.
inline SE3d camera_at(int n) {
  return pose(Vector3<double>(0.02, 0.15, -0.03) * n, Vector3<double>(0.1, -0.02, 0.3) * n);
}

template <int N>
Eigen::Matrix<double, N, N> any_covariance(unsigned seed) {
  Random random(seed);
  Eigen::Matrix<double, N, N> A;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c < N; ++c) A(r, c) = random.normal(0.05);
  return A * A.transpose();
}

}  // namespace dot::test
