// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// Whether the folder has this layout.
bool is_kitti_raw(const std::filesystem::path& folder);

/// A drive of the KITTI raw data, synchronised and rectified: image_02/ and image_03/, or image_00/ and image_01/, each
/// with data/ and timestamps.txt; calib_cam_to_cam.txt here or in the folder above. Besides, if there: depth/, masks/,
/// and as truth oxts/ with calib_imu_to_velo.txt and calib_velo_to_cam.txt.
/// @throws FileError naming the file.
Recording read_kitti_raw(const SequenceOptions& options);

}  // namespace runner
