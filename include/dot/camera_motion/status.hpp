// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace dot {

/// How the camera's motion over the last interval was found.
enum class CameraStatus : std::uint8_t {
  FirstFrame,      ///< no reference yet, or references dropped: T_cur_prev is the identity without meaning; after a
                   ///< gap in time its covariance is that of a motion of which only the limits are known
  Tracked,         ///< estimated from the image
  FromHost,        ///< taken from Frame::camera_motion
  TooLittleDepth,  ///< no earlier frame had enough background points with depth; T_cur_prev is a guess: the host's
                   ///< prior, or constant velocity, with the covariance of a motion of which only the limits are known
  Lost             ///< the alignment failed; T_cur_prev is such a guess, too
};

/// Name of a camera status, lower case with underscores.
constexpr const char* to_string(CameraStatus status) {
  constexpr const char* names[] = {"first_frame", "tracked", "from_host", "too_little_depth", "lost"};
  return status <= CameraStatus::Lost ? names[static_cast<int>(status)] : "?";
}

}  // namespace dot
