// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>

namespace player {

/// The part of OpenCV that reads video files. It is FFmpeg where OpenCV has it: of a file that is no video the others
/// would ask every camera at the machine, with lines of their own on stderr.
inline int video_backend() {
  const auto backends = cv::videoio_registry::getStreamBackends();
  const bool ffmpeg = std::find(backends.begin(), backends.end(), cv::CAP_FFMPEG) != backends.end();
  return ffmpeg ? cv::CAP_FFMPEG : cv::CAP_ANY;
}

}  // namespace player
