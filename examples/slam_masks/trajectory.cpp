// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "trajectory.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace slam {

namespace {

Eigen::Matrix3Xd positions(const std::vector<dot::SE3d>& poses) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(poses.size()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = poses[static_cast<std::size_t>(i)].t;
  return columns;
}

}  // namespace

double absolute_trajectory_error(const std::vector<dot::SE3d>& truth, const std::vector<dot::SE3d>& estimate) {
  const Eigen::Matrix3Xd a = positions(truth), b = positions(estimate);
  const Eigen::Matrix4d T = Eigen::umeyama(b, a, false);
  const Eigen::Matrix3Xd moved = (T.topLeftCorner<3, 3>() * b).colwise() + Eigen::Vector3d(T.topRightCorner<3, 1>());
  return std::sqrt((moved - a).colwise().squaredNorm().mean());
}

double path_length(const std::vector<dot::SE3d>& poses) {
  double length = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) length += (poses[i].t - poses[i - 1].t).norm();
  return length;
}

}  // namespace slam
