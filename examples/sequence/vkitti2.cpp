// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "vkitti2.hpp"

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "entries.hpp"
#include "errors.hpp"
#include "images.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

constexpr double frames_per_second = 10;
constexpr double depth_units_per_metre = 100;

/// A pose and the line on which it stands.
struct PoseLine {
  Eigen::Matrix4d T;
  int line = 0;
};

/// By frame number, for one of the two cameras: T_camera_world.
std::map<int, PoseLine> read_extrinsics(const fs::path& path, int camera) {
  std::map<int, PoseLine> poses;
  for (const Row& row : read_columns(path, {"frame", "cameraID", "r1,1", "r1,2", "r1,3", "t1", "r2,1", "r2,2", "r2,3",
                                            "t2", "r3,1", "r3,2", "r3,3", "t3"})) {
    const Place place{path, row.line};
    const int frame = to_whole(place, "frame", row.values[0], 0, largest_number);
    if (row.values[1] == camera) poses[frame] = {rigid_pose(place, &row.values[2]), row.line};
  }
  return poses;
}

const PoseLine& of_frame(const std::map<int, PoseLine>& poses, int frame, const fs::path& path) {
  const auto found = poses.find(frame);
  if (found == poses.end()) throw FileError(path.string() + ": has no line for frame " + std::to_string(frame));
  return found->second;
}

/// Metres from camera 0 to camera 1 at one frame; 0 without camera 1.
double baseline(const fs::path& extrinsics, int frame) {
  const std::map<int, PoseLine> rights = read_extrinsics(extrinsics, 1);
  if (rights.empty()) return 0;
  const PoseLine& right = of_frame(rights, frame, extrinsics);
  const Eigen::Matrix4d T_world_left = of_frame(read_extrinsics(extrinsics, 0), frame, extrinsics).T.inverse();
  return in_range({extrinsics, right.line}, "the baseline from camera 0 to camera 1", -(right.T * T_world_left)(0, 3),
                  baselines);
}

dot::Intrinsics read_intrinsics(const fs::path& path, cv::Size size) {
  for (const Row& row : read_columns(path, {"cameraID", "K[0,0]", "K[1,1]", "K[0,2]", "K[1,2]"})) {
    if (row.values[0] != 0) continue;
    const std::vector<double>& K = row.values;
    const dot::Intrinsics camera{K[1], K[2], K[3], K[4], size.width, size.height, 0};
    check_intrinsics({path, row.line}, camera);
    return camera;
  }
  throw FileError(path.string() + ": has no line for camera 0");
}

/// Object's pose in the camera's coordinates; origin in the middle of the box's bottom, angles in KITTI's manner.
Eigen::Matrix4d object_pose(const double* position, const double* angles_yxz) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = (Eigen::AngleAxisd(angles_yxz[0], Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(angles_yxz[1], Eigen::Vector3d::UnitX()) *
                             Eigen::AngleAxisd(angles_yxz[2], Eigen::Vector3d::UnitZ()))
                                .toRotationMatrix();
  T.topRightCorner<3, 1>() = Eigen::Vector3d(position);
  return T;
}

using EntryByNumber = std::map<int, RecordingEntry*>;

/// The frame and the object of a row that begins with frame, cameraID and trackID.
struct Sighting {
  RecordingEntry* entry = nullptr;  ///< none: of camera 1, or of a frame that is not played
  int id = 0;                       ///< one above the track's, 0 being the background
};

Sighting sighting(const Place& place, const std::vector<double>& row, const EntryByNumber& entries) {
  const int frame = to_whole(place, "frame", row[0], 0, largest_number);
  const int track = to_whole(place, "trackID", row[2], 0, largest_id - 1);
  const auto entry = entries.find(frame);
  return {row[1] == 0 && entry != entries.end() ? entry->second : nullptr, track + 1};
}

void read_object_poses(const fs::path& path, const EntryByNumber& entries) {
  for (const Row& row :
       read_columns(path, {"frame", "cameraID", "trackID", "camera_space_X", "camera_space_Y", "camera_space_Z",
                           "rotation_camera_space_y", "rotation_camera_space_x", "rotation_camera_space_z"})) {
    const Place place{path, row.line};
    const Sighting seen = sighting(place, row.values, entries);
    check_position(place, Eigen::Vector3d(&row.values[3]));
    if (seen.entry == nullptr) continue;
    TruthEntry& truth = seen.entry->truth;
    truth.poses[seen.id] = *truth.camera * object_pose(&row.values[3], &row.values[6]);
  }
}

/// Speed over the step into the frame, or out of it where the object was not there before; -1 where it is neither.
double speed(const EntryByNumber& entries, int frame, int id) {
  const auto place = [&](int number) -> std::optional<Eigen::Vector3d> {
    const auto entry = entries.find(number);
    if (entry == entries.end()) return std::nullopt;
    const auto pose = entry->second->truth.poses.find(id);
    if (pose == entry->second->truth.poses.end()) return std::nullopt;
    return pose->second.topRightCorner<3, 1>();
  };
  const std::optional<Eigen::Vector3d> now = place(frame);
  for (const int other : {frame - 1, frame + 1})
    if (const auto then = place(other); now && then) return (*now - *then).norm() * frames_per_second;
  return -1;
}

void read_truth(const fs::path& folder, const fs::path& extrinsics, std::vector<RecordingEntry>& entries) {
  EntryByNumber by_number;
  const std::map<int, PoseLine> T_camera_world = read_extrinsics(extrinsics, 0);
  for (RecordingEntry& entry : entries) {
    by_number[entry.number] = &entry;
    entry.truth.camera = of_frame(T_camera_world, entry.number, extrinsics).T.inverse();
  }
  read_object_poses(folder / "pose.txt", by_number);
  const fs::path boxes = folder / "bbox.txt";
  for (const Row& row : read_columns(boxes, {"frame", "cameraID", "trackID", "isMoving"})) {
    const Place place{boxes, row.line};
    const Sighting seen = sighting(place, row.values, by_number);
    const bool moving = to_whole(place, "isMoving", row.values[3], 0, 1) == 1;
    if (seen.entry == nullptr) continue;
    seen.entry->truth.objects[seen.id] = {moving, speed(by_number, seen.entry->number, seen.id)};
  }
}

}  // namespace

bool is_vkitti2(const fs::path& folder) {
  return fs::exists(folder / "intrinsic.txt") && fs::is_directory(folder / "frames" / "rgb");
}

Recording read_vkitti2(const SequenceOptions& options) {
  const fs::path frames = options.folder / "frames";
  const fs::path extrinsics = options.folder / "extrinsic.txt";
  Recording recording;
  recording.layout = "Virtual KITTI 2";
  recording.depth_units_per_metre = depth_units_per_metre;
  recording.entries = list_images(frames / "rgb" / "Camera_0", "rgb_");
  recording.intrinsics =
      read_intrinsics(options.folder / "intrinsic.txt", read_image(recording.entries[0].image).size());
  recording.intrinsics.baseline = baseline(extrinsics, recording.entries[0].number);
  if (options.stereo) {
    if (!(recording.intrinsics.baseline > 0))
      throw FileError(extrinsics.string() + ": camera 1 must be right of camera 0 for stereo");
    recording.depth_source = dot::DepthSource::Stereo;
  }
  const bool own_masks = list_masks(options, recording.entries);
  for (RecordingEntry& entry : recording.entries) {
    const std::string number = frame_name(entry.number, "").substr(1);  // five digits
    entry.timestamp = entry.number / frames_per_second;
    const fs::path depth = frames / "depth" / "Camera_0" / ("depth_" + number + ".png");
    if (options.stereo)
      entry.right = same_frame(frames / "rgb" / "Camera_1", entry);
    else
      entry.depth = depth;
    const fs::path instances = frames / "instanceSegmentation" / "Camera_0" / ("instancegt_" + number + ".png");
    if (options.masks && !own_masks) entry.masks = instances;
    if (options.truth) entry.truth.instance = instances;
    if (options.truth) entry.truth.depth = entry.truth.measured = depth;
  }
  if (options.truth) read_truth(options.folder, extrinsics, recording.entries);
  return recording;
}

}  // namespace runner
