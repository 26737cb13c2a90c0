// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_odometry.hpp"

#include "entries.hpp"
#include "images.hpp"
#include "kitti_calibration.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

/// The files hold poses of camera 0; those of the left camera are wanted.
void read_truth(const fs::path& folder, const Eigen::Vector3d& X_left_0, std::vector<RecordingEntry>& entries) {
  fs::path path = folder / "poses.txt";
  const fs::path absolute = fs::absolute(folder / "").parent_path();
  if (!fs::exists(path)) path = absolute / "../../poses" / (absolute.filename().string() + ".txt");
  if (!fs::exists(path)) return;
  read_poses(path, entries);
  Eigen::Matrix4d T_0_left = Eigen::Matrix4d::Identity();
  T_0_left.topRightCorner<3, 1>() = -X_left_0;
  for (RecordingEntry& entry : entries) entry.truth.camera = *entry.truth.camera * T_0_left;
}

}  // namespace

bool is_kitti_odometry(const fs::path& folder) {
  return fs::exists(folder / "calib.txt") &&
         (fs::is_directory(folder / "image_2") || fs::is_directory(folder / "image_0"));
}

Recording read_kitti_odometry(const SequenceOptions& options) {
  const bool colour = fs::is_directory(options.folder / "image_2");
  const fs::path calibration = options.folder / "calib.txt";
  Recording recording;
  recording.layout = "KITTI odometry";
  recording.entries = list_images(options.folder / (colour ? "image_2" : "image_0"));
  const cv::Size size = read_image(recording.entries[0].image).size();
  const KittiRig rig = read_rig(calibration, colour ? "P2" : "P0", colour ? "P3" : "P1", size);
  recording.intrinsics = rig.intrinsics;
  read_times(options.folder / "times.txt", recording.entries, options.check_times);
  list_masks(options, recording.entries);
  choose_depth(options, options.folder / (colour ? "image_3" : "image_1"), calibration, {}, recording);
  if (options.truth) read_truth(options.folder, rig.X_left_0, recording.entries);
  return recording;
}

}  // namespace runner
