// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "own_layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <system_error>

#include "depth_source.hpp"
#include "errors.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

bool is_image(const fs::path& path) { return path.extension() == ".png" || path.extension() == ".jpg"; }

std::optional<int> frame_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  if (stem.empty() || stem.size() > 9 || stem.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stoi(stem);
}

/// folder/000012.png or .jpg, whichever exists.
fs::path image_path(const fs::path& folder, int number) {
  fs::path path = folder / frame_name(number);
  if (!fs::exists(path) && fs::exists(folder / frame_name(number, ".jpg"))) path = folder / frame_name(number, ".jpg");
  return path;
}

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

std::vector<RecordingEntry> list_images(const fs::path& folder) {
  std::vector<RecordingEntry> entries;
  if (!fs::is_directory(folder)) throw FileError(folder.string() + ": no such folder");
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const std::optional<int> number = frame_number(file.path());
    if (!number || !is_image(file.path())) continue;
    entries.emplace_back();
    entries.back().number = *number;
    entries.back().image = file.path();
  }
  if (entries.empty()) throw FileError(folder.string() + ": holds no images such as 000000.png or 000000.jpg");
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].number == entries[i - 1].number)
      throw FileError(entries[i].image.string() + ": the same frame as " + entries[i - 1].image.string());
  }
  return entries;
}

void read_times(const fs::path& path, double fps, std::vector<RecordingEntry>& entries) {
  if (!fs::exists(path)) {
    for (RecordingEntry& entry : entries) entry.timestamp = entry.number / fps;
    return;
  }
  const std::vector<std::vector<double>> rows = read_table(path, 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries.size(), i, entries[i].number);
    entries[i].timestamp = rows[row][0];
    if (i > 0 && !(entries[i].timestamp > entries[i - 1].timestamp))
      throw FileError(path.string() + ": line " + std::to_string(row + 1) + ": times must increase");
  }
}

/// What the folder says of the depth; exactly one of `depth` and `right` of each entry is filled in.
void choose_depth(const SequenceOptions& options, const std::optional<dot::DepthSource>& stated, Recording& recording) {
  const fs::path depth = options.folder / options.depth_dir;
  const fs::path right = options.folder / "right";
  const bool named = options.depth_dir != SequenceOptions{}.depth_dir;
  const bool has_depth = fs::is_directory(depth);
  const bool has_baseline = recording.intrinsics.baseline > 0;
  if (options.stereo || (!has_depth && !named && fs::is_directory(right))) {
    if (!fs::is_directory(right)) throw FileError(right.string() + ": no such folder (needed for stereo)");
    if (!has_baseline)
      throw FileError((options.folder / "intrinsics.txt").string() + ": baseline must be > 0 for stereo");
    for (RecordingEntry& entry : recording.entries) entry.right = image_path(right, entry.number);
    recording.depth_source = dot::DepthSource::Stereo;
    return;
  }
  if (!has_depth) throw FileError(depth.string() + ": no such folder");
  for (RecordingEntry& entry : recording.entries) entry.depth = depth / frame_name(entry.number);
  recording.depth_source = stated.value_or(has_baseline ? dot::DepthSource::Stereo : dot::DepthSource::Unknown);
}

/// A dangling link counts as there: reading it then says what is wrong.
bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

void list_masks(const SequenceOptions& options, std::vector<RecordingEntry>& entries) {
  const fs::path folder = options.folder / options.mask_dir;
  if (options.mask_dir != SequenceOptions{}.mask_dir && !fs::is_directory(folder))
    throw FileError(folder.string() + ": no such folder");
  for (RecordingEntry& entry : entries) {
    const fs::path masks = folder / frame_name(entry.number);
    if (!is_there(masks)) continue;
    entry.masks = masks;
    const fs::path list = folder / frame_name(entry.number, ".csv");
    if (fs::exists(list)) entry.instances = list;
  }
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

void read_poses(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const std::vector<std::vector<double>> rows = read_table(path, 12);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries.size(), i, entries[i].number);
    entries[i].truth.camera = pose_from_row_major(rows[row].data());
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
  read_times(options.folder / "times.txt", camera.fps, recording.entries);
  list_masks(options, recording.entries);
  choose_depth(options, camera.stated_source, recording);
  if (options.truth) read_truth(options.folder, recording.entries);
  return recording;
}

}  // namespace runner
