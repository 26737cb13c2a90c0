// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// Whether the folder has this layout.
bool is_tum_rgbd(const std::filesystem::path& folder);

/// A recording in the format of the TUM RGB-D benchmark: rgb.txt and depth.txt list times and images, depth with 5000
/// to the metre; groundtruth.txt, if there, the camera's true poses. An image without depth within 20 ms is left out.
///
/// The camera follows from the folder's name (freiburg1, freiburg2, freiburg3, rgbd_bonn), else it is the benchmark's
/// default one. Images are taken for free of distortion. Masks lie in masks/, named as the images or by their number,
/// counted from 0 over the lines of rgb.txt.
/// @throws FileError naming the file.
Recording read_tum_rgbd(const SequenceOptions& options);

}  // namespace runner
