// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "arguments.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/camera/settings.hpp"
#include "dot/pipeline/frame.hpp"
#include "stereo.hpp"

namespace runner {

/// One frame of a sequence in memory; `frame` borrows from it.
struct SequenceFrame {
  int number = 0;  ///< of the files
  double timestamp = 0;
  cv::Mat image;
  cv::Mat depth;
  cv::Mat ids;  ///< empty: no segmentation
  std::vector<dot::Instance> instances;
  std::optional<dot::CameraMotion> camera_motion;

  dot::Frame frame() const;
};

/// A recorded sequence: rgb/, depth/ or right/, masks/, intrinsics.txt, times.txt.
class Sequence {
 public:
  /// Reads everything but the images.
  /// @throws FileError naming the file.
  explicit Sequence(const Arguments& arguments);

  int size() const { return static_cast<int>(entries_.size()); }
  const dot::Intrinsics& intrinsics() const { return intrinsics_; }
  dot::DepthSource depth_source() const { return depth_source_; }
  bool stereo() const { return stereo_.has_value(); }

  /// Reads the images of one frame, 0 <= index < size().
  /// @throws FileError naming the file.
  SequenceFrame read(int index);

 private:
  struct Entry {
    int number = 0;
    std::filesystem::path image;
    double timestamp = 0;
    std::optional<dot::CameraMotion> camera_motion;
  };

  void read_intrinsics();
  void list_images();
  void read_times();
  void read_camera(const std::filesystem::path& path);
  void choose_depth(const Arguments& arguments);
  void read_masks(SequenceFrame& frame) const;
  cv::Size image_size() const { return {intrinsics_.width, intrinsics_.height}; }

  std::filesystem::path folder_;
  std::filesystem::path depth_folder_;
  std::filesystem::path mask_folder_;
  std::vector<std::string> always_dynamic_;
  int mask_every_ = 1;
  dot::Intrinsics intrinsics_;
  double fps_ = 0;
  std::optional<dot::DepthSource> stated_source_;
  dot::DepthSource depth_source_ = dot::DepthSource::Unknown;
  std::vector<Entry> entries_;
  std::optional<StereoDepth> stereo_;
};

}  // namespace runner
