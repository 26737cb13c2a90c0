// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "dot/lie/se3.hpp"

namespace eval {

/// KITTI's odometry figures: mean error over stretches of 100, 200, ... 800 m, relative to their length.
struct StretchError {
  double translation_percent = 0;
  double rotation_deg_per_100m = 0;
  int stretches = 0;
};

/// What a run says of the camera's motion.
struct CameraScore {
  int frames = 0;
  double path_m = 0;                    ///< true length
  std::vector<double> step_cm;          ///< translation error of each step from frame to frame
  std::vector<double> step_deg;         ///< rotation error
  std::vector<double> step_nees;        ///< error of the step over its stated covariance, squared, of each of six axes
  double drift_percent = 0;             ///< error of the last pose relative to the first, over the path
  double ate_m = 0;                     ///< RMS position error after rigid alignment
  std::optional<StretchError> stretch;  ///< absent: the path is too short for one stretch

  double rpe_trans_cm() const;
  double rpe_trans_median_cm() const;
  double rpe_trans_max_cm() const;
  double rpe_rot_deg() const;
  double rpe_rot_median_deg() const;
  double nees_per_axis() const;  ///< not a number where no step was estimated
};

using Poses = std::vector<Eigen::Matrix4d>;  ///< T_world_camera; the worlds of truth and estimate may differ

/// Normalised error squared of a motion T_cur_prev, per axis; 1 on average when the covariance, of its left twist, is
/// true.
double camera_nees(const dot::SE3d& truth, const dot::SE3d& estimate, const dot::Matrix6<double>& covariance);

/// @param truth, estimate of the same frames, at least two.
CameraScore score_camera(const Poses& truth, const Poses& estimate);

}  // namespace eval
