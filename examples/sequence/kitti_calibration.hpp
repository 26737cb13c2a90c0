// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "dot/camera/intrinsics.hpp"
#include "fields.hpp"

namespace runner {

/// The rectified stereo pair of a KITTI calibration, and where its left camera is.
struct KittiRig {
  dot::Intrinsics intrinsics;
  Eigen::Vector3d X_left_0;  ///< the reference camera's origin in the left one's coordinates; the axes are parallel
};

/// The numbers of the line `key: number number ...` of a calibration file.
/// @throws FileError when there is no such line, naming the line when it does not have so many numbers.
Row read_calibration(const std::filesystem::path& path, const std::string& key, std::size_t count);

/// @param left, right keys of the 3x4 projection matrices K [I t] from the reference camera's coordinates.
/// @throws FileError naming the line that is not such a matrix or not one of a pair.
KittiRig read_rig(const std::filesystem::path& path, const std::string& left, const std::string& right, cv::Size image);

}  // namespace runner
