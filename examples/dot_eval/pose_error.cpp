// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "pose_error.hpp"

#include <Eigen/LU>
#include <cmath>

namespace eval {

double rotation_angle_deg(const Eigen::Matrix3d& R) {
  constexpr double degrees_per_radian = 180 / 3.14159265358979323846;
  const Eigen::Vector3d axis(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  return degrees_per_radian * std::atan2(axis.norm() / 2, (R.trace() - 1) / 2);
}

MotionError motion_error(const Eigen::Matrix4d& T_o, const Eigen::Matrix4d& camera, const Eigen::Matrix4d& before,
                         const Eigen::Matrix4d& after) {
  const Eigen::Matrix4d T_camera_world = camera.inverse();
  const Eigen::Matrix4d truth = T_camera_world * after * before.inverse() * camera;
  const Eigen::Vector4d origin = T_camera_world * before.col(3);
  const Eigen::Matrix3d rotation = truth.topLeftCorner<3, 3>().transpose() * T_o.topLeftCorner<3, 3>();
  return {(T_o * origin - truth * origin).head<3>().norm(), rotation_angle_deg(rotation)};
}

}  // namespace eval
