// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "own_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "depth_source.hpp"
#include "entries.hpp"
#include "images.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

struct Camera {
  dot::Intrinsics intrinsics;
  double fps = 0;
  std::optional<dot::DepthSource> stated_source;
};

Camera read_intrinsics(const fs::path& path) {
  const char* const names[] = {"fx", "fy", "cx", "cy", "width", "height", "baseline", "fps"};
  constexpr int largest_side = 65535;
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> fields = words(lines.empty() ? "" : lines[0]);
  Place place{path, 1};
  double values[std::size(names)] = {};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (i >= fields.size()) fail(place, std::string(names[i]) + " is missing");
    values[i] = to_number(place, names[i], fields[i]);
  }
  if (fields.size() > std::size(names)) fail(place, "has more than eight numbers");
  Camera camera;
  camera.intrinsics = {values[0],
                       values[1],
                       values[2],
                       values[3],
                       to_whole(place, "width", values[4], 1, largest_side),
                       to_whole(place, "height", values[5], 1, largest_side),
                       values[6]};
  check_intrinsics(place, camera.intrinsics);
  camera.fps = in_range(place, "fps", values[7], frame_rates);

  for (std::size_t i = 1; i < lines.size(); ++i) {
    ++place.line;
    const std::vector<std::string> line = words(lines[i]);
    if (line.empty()) continue;
    if (camera.stated_source) fail(place, "nothing may follow the line of the depth");
    if (line.size() == 2 && line[0] == "depth") camera.stated_source = depth_source_by_name(line[1]);
    if (!camera.stated_source) fail(place, "must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'");
  }
  return camera;
}

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
  const Camera camera = read_intrinsics(options.folder / "intrinsics.txt");
  recording.intrinsics = camera.intrinsics;
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
