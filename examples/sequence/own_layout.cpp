// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "own_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "entries.hpp"
#include "images.hpp"
#include "intrinsics_file.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

// --- Truth -----------------------------------------------------------------------------------------------------------

using EntryByNumber = std::map<int, RecordingEntry*>;

/// Columns frame, id, moving and speed_mps of objects.csv, in any order among others.
void read_objects(const fs::path& path, const EntryByNumber& entries) {
  constexpr Range speeds{-1e5, 1e5};
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> header = split(lines.empty() ? "" : lines[0], ',');
  const char* const names[] = {"frame", "id", "moving", "speed_mps"};
  Place place{path, 1};
  std::size_t columns[4] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = std::find(header.begin(), header.end(), names[i]);
    if (found == header.end()) fail(place, std::string("has no column '") + names[i] + "'");
    columns[i] = static_cast<std::size_t>(found - header.begin());
  }
  for (std::size_t line = 1; line < lines.size(); ++line) {
    ++place.line;
    if (trim(lines[line]).empty()) continue;
    const std::vector<std::string> fields = split(lines[line], ',');
    double values[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
      if (columns[i] >= fields.size()) fail(place, std::string("has no ") + names[i]);
      values[i] = to_number(place, names[i], fields[columns[i]]);
    }
    const auto entry = entries.find(to_whole(place, "frame", values[0], 0, largest_number));
    const int id = to_whole(place, "id", values[1], 1, largest_id);
    const bool moving = to_whole(place, "moving", values[2], 0, 1) == 1;
    const double speed = in_range(place, "speed_mps", values[3], speeds);
    if (entry != entries.end()) entry->second->truth.objects[id] = {moving, speed};
  }
}

void read_object_poses(const fs::path& path, const EntryByNumber& entries) {
  for (const Row& row : read_table(path, 14)) {
    const Place place{path, row.line};
    const auto entry = entries.find(to_whole(place, "frame", row.values[0], 0, largest_number));
    const int id = to_whole(place, "id", row.values[1], 1, largest_id);
    const Eigen::Matrix4d pose = rigid_pose(place, &row.values[2]);
    if (entry != entries.end()) entry->second->truth.poses[id] = pose;
  }
}

void read_truth(const fs::path& folder, std::vector<RecordingEntry>& entries) {
  if (fs::exists(folder / "poses.txt")) read_poses(folder / "poses.txt", entries);
  if (!fs::is_directory(folder / "instance")) return;
  EntryByNumber by_number;
  const bool perfect = fs::is_directory(folder / "depth_true");
  const auto if_there = [](const fs::path& path) { return is_there(path) ? path : fs::path(); };
  for (RecordingEntry& entry : entries) {
    by_number[entry.number] = &entry;
    const std::string name = frame_name(entry.number);
    entry.truth.instance = if_there(folder / "instance" / name);
    entry.truth.measured = if_there(folder / "depth" / name);
    entry.truth.depth = perfect ? if_there(folder / "depth_true" / name) : entry.truth.measured;
  }
  read_objects(folder / "objects.csv", by_number);
  if (fs::exists(folder / "object_poses.txt")) read_object_poses(folder / "object_poses.txt", by_number);
}

}  // namespace

Recording read_own_layout(const SequenceOptions& options) {
  Recording recording;
  recording.layout = "own layout";
  const CameraFile camera = read_camera_file(options.folder / "intrinsics.txt");
  recording.intrinsics = camera.intrinsics;
  recording.distortion = camera.distortion;
  recording.entries = list_images(options.folder / "rgb");
  // Before anybody takes memory for images of the size that is claimed.
  read_image(recording.entries[0].image, {camera.intrinsics.width, camera.intrinsics.height});
  for (RecordingEntry& entry : recording.entries) entry.timestamp = entry.number / camera.fps;
  if (fs::exists(options.folder / "times.txt"))
    read_times(options.folder / "times.txt", recording.entries, options.check_times);
  list_masks(options, recording.entries);
  choose_depth(options, options.folder / "right", options.folder / "intrinsics.txt", camera.stated_source, recording);
  if (options.truth) read_truth(options.folder, recording.entries);
  return recording;
}

}  // namespace runner
