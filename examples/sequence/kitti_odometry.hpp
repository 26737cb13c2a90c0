// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// Whether the folder has this layout.
bool is_kitti_odometry(const std::filesystem::path& folder);

/// A sequence of the KITTI odometry benchmark (its devkit's readme): image_2/ and image_3/, or image_0/ and image_1/,
/// calib.txt, times.txt. Besides, if there: depth/, masks/, and as truth poses.txt or ../../poses/<name of folder>.txt.
/// @throws FileError naming the file.
Recording read_kitti_odometry(const SequenceOptions& options);

}  // namespace runner
