// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/lie/se3.hpp"

namespace slam {

/// Root mean square distance of the positions, in metres, after the rigid motion of the estimate that makes it least
/// (Umeyama, "Least-squares estimation of transformation parameters between two point patterns", 1991, without scale).
/// @param truth, estimate camera-to-world poses, one for each frame, in worlds of their own.
double absolute_trajectory_error(const std::vector<dot::SE3d>& truth, const std::vector<dot::SE3d>& estimate);

/// Length of the way from position to position, metres.
double path_length(const std::vector<dot::SE3d>& poses);

}  // namespace slam
