// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "dot/camera/intrinsics.hpp"
#include "fields.hpp"
#include "text.hpp"

/// @file
/// What a recording can hold. The ranges are wide: they are to find a wrong file or unit, not an unusual camera.

namespace runner {

constexpr int largest_number = 999999999;       ///< of a frame
constexpr int largest_id = 65535;               ///< of an object: images of ids have 16 bits
constexpr Range focal_lengths{1, 1e6};          ///< pixels
constexpr Range principal_points{-1e5, 1e5};    ///< pixels; a cropped image's may lie outside of it
constexpr Range baselines{0, 10};               ///< metres
constexpr Range frame_rates{1e-3, 1e5};         ///< per second
constexpr Range positions{-1e9, 1e9};           ///< metres; those on a map of the earth reach 2e7
constexpr Range times{-1e11, 1e11};             ///< seconds; more are of another unit
constexpr double shortest_step = 1e-6;          ///< seconds from frame to frame
constexpr double rounding_of_rotations = 1e-3;  ///< of R R^T: files are written with a few digits

/// @throws FileError naming what of the camera is not plausible; its size is not looked at.
void check_intrinsics(const Place& place, const dot::Intrinsics& camera);

/// @throws FileError when the time does not increase, in seconds.
void check_step(const Place& place, double before, double time);

/// The units of depth images to the metre.
/// @param name to begin the message with.
/// @throws Error when it is not plausible.
template <typename Error>
double depth_scale(const std::string& name, const std::string& text) {
  constexpr double most = 1e6;
  const std::optional<double> scale = parse_number(text);
  if (scale && *scale > 0 && *scale < 1)
    throw Error(name + " is the number of units to the metre: of units of " + text + " m these are " +
                format("%.6g", 1 / *scale));
  if (!scale || !(*scale >= 1 && *scale <= most))
    throw Error(name + " needs a number from 1 to 1000000, not '" + text + "'");
  return *scale;
}

/// @param name to begin the message with.
/// @throws FileError when R is not a rotation, to a file's few digits.
void check_rotation(const Place& place, const std::string& name, const Eigen::Matrix3d& R);

/// @throws FileError when a coordinate is out of range.
void check_position(const Place& place, const Eigen::Vector3d& position);

/// A pose as KITTI writes it, 3x4 row-major, as it stands: a matrix that is rounded, not a clean rotation.
/// @param values 12 numbers.
/// @throws FileError when it is not rigid.
Eigen::Matrix4d rigid_pose(const Place& place, const double* values);

}  // namespace runner
