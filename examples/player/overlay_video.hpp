// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "dot/pipeline/result.hpp"
#include "sequence/recording.hpp"
#include "sequence/sequence.hpp"
#include "video_file.hpp"

namespace player {

/// The pictures of --overlay as a video, one for each frame of the recording. While frames are left out, as in real
/// time, the last picture stays, so that the video lasts as long as the recording.
class OverlayVideo {
 public:
  /// @param fps pictures a second; absent: by the median interval of the recording.
  /// @throws FileError as VideoFile.
  OverlayVideo(const std::filesystem::path& path, const runner::Recording& recording, std::optional<double> fps);

  /// @throws FileError as VideoFile.
  void add(const runner::SequenceFrame& frame, const dot::Result& result, double total_ms);

  /// @throws FileError as VideoFile.
  void finish() { file_.finish(); }

 private:
  VideoFile file_;
  std::vector<int> numbers_;  ///< of the frames, ascending
  std::size_t next_ = 0;      ///< frame whose picture is not in the video yet
  cv::Mat picture_;           ///< the last one
};

}  // namespace player
