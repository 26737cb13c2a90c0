// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "recording.hpp"

namespace runner {

/// Whether the folder has this layout.
bool is_vkitti2(const std::filesystem::path& folder);

/// A variation of a scene of Virtual KITTI 2, such as Scene01/clone: frames/{rgb,depth,instanceSegmentation}/Camera_0,
/// intrinsic.txt, extrinsic.txt, and as truth instanceSegmentation, pose.txt and bbox.txt. With the stereo option the
/// right images are those of Camera_1. Ten frames a second.
///
/// Masks are taken from masks/, named as the images, or by default from the instance segmentation itself. Ids are the
/// dataset's trackID + 1, since 0 is background.
/// @throws FileError naming the file.
Recording read_vkitti2(const SequenceOptions& options);

}  // namespace runner
