// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

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
  double drift_percent = 0;             ///< error of the last pose relative to the first, over the path
  double ate_m = 0;                     ///< RMS position error after rigid alignment
  std::optional<StretchError> stretch;  ///< absent: the path is too short for one stretch

  double rpe_trans_cm() const;
  double rpe_trans_median_cm() const;
  double rpe_trans_max_cm() const;
  double rpe_rot_deg() const;
  double rpe_rot_median_deg() const;
};

using Poses = std::vector<Eigen::Matrix4d>;  ///< T_world_camera; the worlds of truth and estimate may differ

/// @param truth, estimate of the same frames, at least two.
CameraScore score_camera(const Poses& truth, const Poses& estimate);

}  // namespace eval
