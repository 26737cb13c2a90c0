// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "distortion.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/camera/settings.hpp"

namespace runner {

/// What a file says of a camera.
struct CameraFile {
  dot::Intrinsics intrinsics;
  double fps = 0;
  std::optional<dot::DepthSource> stated_source;
  std::optional<Distortion> distortion;
  std::optional<double> depth_units_per_metre;
};

/// Reads a camera: the project's own text file, a line `fx fy cx cy width height baseline fps`, and optionally lines
/// `depth SOURCE` and `distortion MODEL COEFFICIENT...`; or, where the name ends in .json, the intrinsic.json that
/// Open3D writes beside the images of a RealSense or Azure Kinect recording.
/// @throws FileError naming the line or the field.
CameraFile read_camera_file(const std::filesystem::path& path);

}  // namespace runner
