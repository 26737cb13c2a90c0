// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

namespace runner {

/// A video that is read frame by frame. Not every program can: see SequenceOptions::open_video.
class VideoInput {
 public:
  virtual ~VideoInput() = default;

  /// Seconds, one a frame.
  virtual const std::vector<double>& times() const = 0;

  /// A frame; cheapest in their order.
  /// @throws FileError naming the file.
  virtual cv::Mat read(int index) = 0;
};

/// @throws FileError when the file is no video that can be read.
using OpenVideo = std::function<std::unique_ptr<VideoInput>(const std::filesystem::path&)>;

/// Whether a name is that of a video, by its ending.
bool is_video(const std::filesystem::path& path);

}  // namespace runner
