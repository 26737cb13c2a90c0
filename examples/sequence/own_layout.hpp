// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// The project's own layout: rgb/, depth/ or right/, masks/, intrinsics.txt, times.txt; and for scoring instance/,
/// objects.csv, poses.txt, object_poses.txt, depth_true/. docs/evaluation.md lists the formats.
/// @throws FileError naming the file.
Recording read_own_layout(const SequenceOptions& options);

}  // namespace runner
