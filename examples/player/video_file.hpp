// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>

namespace player {

/// A video of pictures of one size, by OpenCV's module videoio. It has its name when it is finished, and else leaves
/// nothing. H.264 where OpenCV can encode it, else MPEG-4.
class VideoFile {
 public:
  /// @param path ends in .mp4, .mkv or .avi. @param fps pictures a second.
  /// @throws FileError when the folder cannot be written to, or when the program was built without videoio.
  VideoFile(std::filesystem::path path, double fps);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// @param picture CV_8UC3.
  /// @throws FileError when no encoder can be found.
  void add(const cv::Mat& picture);

  /// @throws FileError when the file does not hold all pictures.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace player
