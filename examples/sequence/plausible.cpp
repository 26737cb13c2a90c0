// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "plausible.hpp"

#include <Eigen/LU>

#include "recording.hpp"

namespace runner {

void check_intrinsics(const Place& place, const dot::Intrinsics& camera) {
  in_range(place, "fx", camera.fx, focal_lengths);
  in_range(place, "fy", camera.fy, focal_lengths);
  in_range(place, "cx", camera.cx, principal_points);
  in_range(place, "cy", camera.cy, principal_points);
  in_range(place, "baseline", camera.baseline, baselines);
}

void check_step(const Place& place, double before, double time) {
  if (!(time - before >= shortest_step)) fail(place, "times must increase, by a microsecond or more");
}

void check_rotation(const Place& place, const std::string& name, const Eigen::Matrix3d& R) {
  // Of huge elements the product is not finite, which the comparison refuses as well.
  if (!((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() <= rounding_of_rotations))
    fail(place, name + " is not a rotation");
  if (R.determinant() < 0) fail(place, name + " is a mirror image, not a rotation");
}

void check_position(const Place& place, const Eigen::Vector3d& position) {
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) in_range(place, names[axis], position[axis], positions);
}

Eigen::Matrix4d rigid_pose(const Place& place, const double* values) {
  Eigen::Matrix4d pose = pose_from_row_major(values);
  check_rotation(place, "the pose's 3x3 part", pose.topLeftCorner<3, 3>());
  check_position(place, pose.topRightCorner<3, 1>());
  return pose;
}

}  // namespace runner
