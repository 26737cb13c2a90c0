// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "own_layout.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "depth_source.hpp"
#include "entries.hpp"
#include "errors.hpp"
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
  Camera camera;
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> fields = words(lines.empty() ? "" : lines[0]);
  const char* const names[] = {"fx", "fy", "cx", "cy", "width", "height", "baseline", "fps"};
  double values[8] = {};
  for (std::size_t i = 0; i < 8; ++i) {
    if (i >= fields.size()) throw FileError(path.string() + ": " + names[i] + " is missing");
    const std::optional<double> number = parse_number(fields[i]);
    if (!number) throw FileError(path.string() + ": " + names[i] + " '" + fields[i] + "' is not a number");
    const bool positive = i == 0 || i == 1 || i == 4 || i == 5 || i == 7;
    if (positive && !(*number > 0)) throw FileError(path.string() + ": " + names[i] + " must be > 0");
    if (i == 6 && *number < 0) throw FileError(path.string() + ": baseline must be >= 0");
    if ((i == 4 || i == 5) && (*number > 65535 || *number != static_cast<int>(*number)))
      throw FileError(path.string() + ": " + names[i] + " must be a whole number up to 65535");
    values[i] = *number;
  }
  camera.intrinsics = {
      values[0], values[1], values[2], values[3], static_cast<int>(values[4]), static_cast<int>(values[5]), values[6]};
  camera.fps = values[7];

  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> line = words(lines[i]);
    if (line.empty()) continue;
    if (line.size() == 2 && line[0] == "depth") camera.stated_source = depth_source_by_name(line[1]);
    if (!camera.stated_source)
      throw FileError(path.string() + ": line " + std::to_string(i + 1) +
                      " must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'");
  }
  return camera;
}

// --- Truth -----------------------------------------------------------------------------------------------------------

using EntryByNumber = std::map<int, RecordingEntry*>;

/// Columns frame, id, moving and speed_mps of objects.csv, in any order among others.
void read_objects(const fs::path& path, const EntryByNumber& entries) {
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> header = split(lines.empty() ? "" : lines[0], ',');
  const char* const names[] = {"frame", "id", "moving", "speed_mps"};
  std::size_t columns[4] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = std::find(header.begin(), header.end(), names[i]);
    if (found == header.end()) throw FileError(path.string() + ": has no column '" + names[i] + "'");
    columns[i] = static_cast<std::size_t>(found - header.begin());
  }
  for (std::size_t line = 1; line < lines.size(); ++line) {
    const std::vector<std::string> fields = split(lines[line], ',');
    if (trim(lines[line]).empty()) continue;
    double values[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::optional<double> number =
          columns[i] < fields.size() ? parse_number(fields[columns[i]]) : std::optional<double>();
      if (!number) throw FileError(path.string() + ": line " + std::to_string(line + 1) + ": no " + names[i]);
      values[i] = *number;
    }
    const auto entry = entries.find(static_cast<int>(values[0]));
    if (entry != entries.end()) entry->second->truth.objects[static_cast<int>(values[1])] = {values[2] == 1, values[3]};
  }
}

void read_object_poses(const fs::path& path, const EntryByNumber& entries) {
  for (const std::vector<double>& row : read_table(path, 14)) {
    const auto entry = entries.find(static_cast<int>(row[0]));
    if (entry != entries.end()) entry->second->truth.poses[static_cast<int>(row[1])] = pose_from_row_major(&row[2]);
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
  for (RecordingEntry& entry : recording.entries) entry.timestamp = entry.number / camera.fps;
  if (fs::exists(options.folder / "times.txt")) read_times(options.folder / "times.txt", recording.entries);
  list_masks(options, recording.entries);
  choose_depth(options, options.folder / "right", options.folder / "intrinsics.txt", camera.stated_source, recording);
  if (options.truth) read_truth(options.folder, recording.entries);
  return recording;
}

}  // namespace runner
