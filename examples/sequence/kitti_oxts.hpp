// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "recording.hpp"

namespace runner {

/// Where the left camera is on KITTI's car.
struct OxtsCalibration {
  std::filesystem::path cam_to_cam;
  std::filesystem::path imu_to_velo;
  std::filesystem::path velo_to_cam;
  Eigen::Vector3d X_left_0;  ///< as in KittiRig
};

/// The camera's true poses from the inertial and satellite navigation of KITTI's raw data, good to some centimetres:
/// east, north, up in metres on a Mercator map scaled at the first frame's latitude (raw devkit's readme).
/// @param folder of the files 0000000000.txt, one for each frame: latitude, longitude (deg), altitude (m), roll, pitch,
///   yaw (rad), and more.
/// @throws FileError naming the file.
void read_oxts(const std::filesystem::path& folder, const OxtsCalibration& calibration,
               std::vector<RecordingEntry>& entries);

}  // namespace runner
