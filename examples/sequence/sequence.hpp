// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dot/frame/frame.hpp"
#include "recording.hpp"
#include "stereo.hpp"

namespace runner {

/// One frame of a sequence in memory; `frame` borrows from it.
struct SequenceFrame {
  int number = 0;  ///< of the files
  double timestamp = 0;
  cv::Mat image;
  cv::Mat depth;  ///< CV_16UC1, or CV_32FC1 in metres
  double depth_units_per_metre = 256;
  bool masks_wanted = true;  ///< SequenceOptions::mask_every does not leave this frame out
  cv::Mat ids;               ///< empty: no segmentation, unless there is a list
  std::vector<dot::Instance> instances;
  cv::Mat filled;  ///< CV_8UC1, all set: what a list of boxes borrows
  std::optional<dot::CameraMotion> camera_motion;

  dot::Frame frame() const;
};

/// The images of a TruthEntry; empty where it has none.
struct FrameTruth {
  cv::Mat instance;  ///< CV_32SC1
  cv::Mat depth;     ///< CV_32FC1, metres, 0 = none
  cv::Mat measured;  ///< likewise
};

/// A recorded sequence of any layout that layouts.hpp knows, read frame by frame.
class Sequence {
 public:
  /// Reads everything but the images.
  /// @throws FileError naming the file.
  explicit Sequence(const SequenceOptions& options);

  int size() const { return static_cast<int>(recording_.entries.size()); }
  const Recording& recording() const { return recording_; }
  const dot::Intrinsics& intrinsics() const { return recording_.intrinsics; }
  dot::DepthSource depth_source() const { return recording_.depth_source; }
  bool stereo() const { return stereo_.has_value(); }

  /// Reads the images of one frame, 0 <= index < size().
  /// @throws FileError naming the file.
  SequenceFrame read(int index);

  /// Reads the images of one frame's truth; the rest of it is in recording().entries[index].truth.
  /// @throws FileError naming the file.
  FrameTruth truth(int index) const;

 private:
  void read_camera(const std::filesystem::path& path);
  cv::Mat read_frame(const std::filesystem::path& path, const RecordingEntry& entry) const;
  cv::Mat read_colour(const std::filesystem::path& path, const RecordingEntry& entry) const;
  cv::Mat read_depth(const std::filesystem::path& path, const RecordingEntry& entry) const;
  cv::Mat undistorted(const cv::Mat& labels) const;
  cv::Mat read_ids(const std::filesystem::path& path) const;
  cv::Mat read_metres(const std::filesystem::path& path, const RecordingEntry& entry) const;
  cv::Size image_size() const { return {recording_.intrinsics.width, recording_.intrinsics.height}; }

  Recording recording_;
  std::vector<std::string> always_dynamic_;
  int mask_every_ = 1;
  std::vector<std::optional<dot::CameraMotion>> camera_motions_;
  std::optional<StereoDepth> stereo_;
  std::optional<Undistorter> undistorter_;
};

}  // namespace runner
