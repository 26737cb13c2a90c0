// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "dot/image/opencv.hpp"
#include "dot/lie/se3.hpp"
#include "entries.hpp"
#include "errors.hpp"
#include "images.hpp"
#include "instance_list.hpp"
#include "layouts.hpp"
#include "plausible.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

dot::CameraMotion camera_motion(const dot::SE3d& T_world_prev, const dot::SE3d& T_world_cur) {
  // A file says nothing of its errors. What it gives is taken as right, to what its digits and a street's images allow:
  // claiming more leaves less to hold against an object.
  constexpr double sigma_metres = 0.0001;
  constexpr double sigma_radians = 0.0005 * 3.14159265358979323846 / 180;
  dot::CameraMotion motion;
  motion.T_cur_prev = (T_world_cur.inverse() * T_world_prev).row_major();
  for (std::size_t i = 0; i < 6; ++i) {
    const double sigma = i < 3 ? sigma_metres : sigma_radians;
    motion.covariance[7 * i] = sigma * sigma;
  }
  return motion;
}

}  // namespace

dot::Frame SequenceFrame::frame() const {
  dot::Frame frame;
  frame.id = static_cast<std::uint64_t>(number);
  frame.timestamp = timestamp;
  frame.image = dot::view(image);
  frame.depth = dot::depth_view(depth, depth_units_per_metre);
  const dot::Span<dot::Instance> list{instances.data(), instances.size()};
  if (!ids.empty()) frame.masks = dot::Masks{dot::id_view(ids), list};
  if (!filled.empty()) frame.masks = dot::Masks{{}, list};
  frame.camera_motion = camera_motion;
  return frame;
}

Sequence::Sequence(const SequenceOptions& options)
    : recording_(open_recording(options)),
      always_dynamic_(options.always_dynamic),
      mask_every_(options.mask_every),
      camera_motions_(recording_.entries.size()) {
  if (!options.camera.empty()) read_camera(options.camera);
  if (!recording_.entries[0].right.empty()) stereo_.emplace(recording_.intrinsics);
  if (recording_.distortion) undistorter_.emplace(recording_.intrinsics, *recording_.distortion);
}

cv::Mat Sequence::read_frame(const fs::path& path, const RecordingEntry& entry) const {
  const auto video = recording_.videos.find(path);
  if (video == recording_.videos.end()) return read_image(path, image_size());
  cv::Mat image = video->second->read(entry.video_frame);
  check_size(path, image, image_size());
  return image;
}

cv::Mat Sequence::read_colour(const fs::path& path, const RecordingEntry& entry) const {
  cv::Mat image = read_frame(path, entry);
  if (image.depth() != CV_8U || image.channels() == 2)
    throw FileError(path.string() + ": must be 8-bit grey or colour");
  return undistorter_ ? undistorter_->image(image) : image;
}

cv::Mat Sequence::read_depth(const fs::path& path, const RecordingEntry& entry) const {
  const cv::Mat depth = read_frame(path, entry);
  if (depth.type() != CV_16UC1 && recording_.videos.count(path) > 0)
    throw FileError(path.string() + ": does not come as 16-bit grey; make images of it: ffmpeg -i " +
                    path.filename().string() + " -pix_fmt gray16be depth/%06d.png");
  if (depth.type() != CV_16UC1) throw FileError(path.string() + ": must be a 16-bit grey image");
  return undistorted(depth);
}

cv::Mat Sequence::undistorted(const cv::Mat& labels) const {
  return undistorter_ ? undistorter_->labels(labels) : labels;
}

void Sequence::read_camera(const fs::path& path) {
  const std::vector<Row> rows = read_table(path, 12);
  std::vector<dot::SE3d> poses;
  for (std::size_t i = 0; i < camera_motions_.size(); ++i) {
    const Row& row = rows[row_of(path, rows.size(), camera_motions_.size(), i, recording_.entries[i].number)];
    const Eigen::Matrix4d T_world_camera = rigid_pose({path, row.line}, row.values.data());
    poses.push_back(
        dot::SE3d{T_world_camera.topLeftCorner<3, 3>(), T_world_camera.topRightCorner<3, 1>()}.normalized());
    if (i > 0) camera_motions_[i] = camera_motion(poses[i - 1], poses[i]);
  }
}

SequenceFrame Sequence::read(int index) {
  const auto i = static_cast<std::size_t>(index);
  const RecordingEntry& entry = recording_.entries[i];
  SequenceFrame frame;
  frame.number = entry.number;
  frame.timestamp = entry.timestamp;
  frame.camera_motion = camera_motions_[i];
  frame.depth_units_per_metre = recording_.depth_units_per_metre;
  frame.image = read_colour(entry.image, entry);
  frame.depth =
      stereo_ ? stereo_->compute(frame.image, read_colour(entry.right, entry)) : read_depth(entry.depth, entry);
  frame.masks_wanted = index % mask_every_ == 0;
  if (!frame.masks_wanted || entry.masks.empty()) return frame;
  if (entry.coco) {
    Segmentation masks = entry.coco->read(image_name(entry), image_size(), always_dynamic_);
    frame.ids = undistorted(masks.ids);
    frame.instances = std::move(masks.instances);
    return frame;
  }
  frame.ids = read_ids(entry.masks);
  if (!entry.instances.empty()) frame.instances = read_instances(entry.instances, always_dynamic_);
  return frame;
}

cv::Mat Sequence::read_ids(const fs::path& path) const {
  cv::Mat ids = read_indices(path, image_size());
  if (ids.type() != CV_8UC1 && ids.type() != CV_16UC1)
    throw FileError(path.string() + ": must be an 8-bit or 16-bit grey image of ids");
  return undistorted(ids);
}

cv::Mat Sequence::read_metres(const fs::path& path, const RecordingEntry& entry) const {
  cv::Mat metres;
  if (!path.empty()) read_depth(path, entry).convertTo(metres, CV_32F, 1 / recording_.depth_units_per_metre);
  return metres;
}

FrameTruth Sequence::truth(int index) const {
  const RecordingEntry& recorded = recording_.entries[static_cast<std::size_t>(index)];
  const TruthEntry& entry = recorded.truth;
  FrameTruth truth;
  if (!entry.instance.empty()) read_ids(entry.instance).convertTo(truth.instance, CV_32S);
  truth.depth = read_metres(entry.depth, recorded);
  truth.measured = entry.measured == entry.depth ? truth.depth : read_metres(entry.measured, recorded);
  return truth;
}

}  // namespace runner
