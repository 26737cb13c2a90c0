// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace eval {

/// Rotation angle of a matrix, degrees; exact near zero, where the arc cosine of the trace is not.
double rotation_angle_deg(const Eigen::Matrix3d& R);

struct MotionError {
  double metres = 0;
  double degrees = 0;
};

/// Error of an object's motion T_o, in the previous camera's coordinates, at the object's origin.
/// @param camera T_world_camera of the previous frame.
/// @param before, after T_world_object in the previous frame and in this one.
MotionError motion_error(const Eigen::Matrix4d& T_o, const Eigen::Matrix4d& camera, const Eigen::Matrix4d& before,
                         const Eigen::Matrix4d& after);

}  // namespace eval
