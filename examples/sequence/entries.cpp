// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "entries.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "errors.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

bool is_image(const fs::path& path) { return path.extension() == ".png" || path.extension() == ".jpg"; }

std::optional<int> frame_number(const std::string& stem, const std::string& prefix) {
  if (stem.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
  const std::string digits = stem.substr(prefix.size());
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  const std::string significant = digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  if (significant.size() > 9) return std::nullopt;
  return std::stoi(significant);
}

}  // namespace

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

std::vector<RecordingEntry> list_images(const fs::path& folder, const std::string& prefix) {
  std::vector<RecordingEntry> entries;
  if (!fs::is_directory(folder)) throw FileError(folder.string() + ": no such folder");
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const std::optional<int> number = frame_number(file.path().stem().string(), prefix);
    if (!number || !is_image(file.path())) continue;
    entries.emplace_back();
    entries.back().number = *number;
    entries.back().image = file.path();
  }
  if (entries.empty())
    throw FileError(folder.string() + ": holds no images such as " + prefix + "000000.png or " + prefix + "000000.jpg");
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (entries[i].number == entries[i - 1].number)
      throw FileError(entries[i].image.string() + ": the same frame as " + entries[i - 1].image.string());
  }
  return entries;
}

fs::path same_frame(const fs::path& folder, const RecordingEntry& entry) {
  const std::string stem = entry.image.stem().string();
  const std::string six_digits = frame_name(entry.number, "");
  for (const std::string& name : {stem + ".png", stem + ".jpg", six_digits + ".png", six_digits + ".jpg"})
    if (is_there(folder / name)) return folder / name;
  return folder / (stem + ".png");
}

void read_times(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const std::vector<std::vector<double>> rows = read_table(path, 1);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries.size(), i, entries[i].number);
    entries[i].timestamp = rows[row][0];
    if (i > 0 && !(entries[i].timestamp > entries[i - 1].timestamp))
      throw FileError(path.string() + ": line " + std::to_string(row + 1) + ": times must increase");
  }
}

void read_poses(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const std::vector<std::vector<double>> rows = read_table(path, 12);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries.size(), i, entries[i].number);
    entries[i].truth.camera = pose_from_row_major(rows[row].data());
  }
}

bool list_masks(const SequenceOptions& options, std::vector<RecordingEntry>& entries) {
  const fs::path folder = options.folder / options.mask_dir;
  if (!fs::is_directory(folder)) {
    if (options.mask_dir != SequenceOptions{}.mask_dir) throw FileError(folder.string() + ": no such folder");
    return false;
  }
  for (RecordingEntry& entry : entries) {
    const fs::path masks = same_frame(folder, entry);
    if (!is_there(masks)) continue;
    entry.masks = masks;
    const fs::path list = fs::path(masks).replace_extension(".csv");
    if (fs::exists(list)) entry.instances = list;
  }
  return true;
}

void choose_depth(const SequenceOptions& options, const fs::path& right, const fs::path& calibration,
                  std::optional<dot::DepthSource> stated, Recording& recording) {
  const fs::path depth = options.folder / options.depth_dir;
  const bool named = options.depth_dir != SequenceOptions{}.depth_dir;
  const bool has_depth = fs::is_directory(depth);
  const bool has_baseline = recording.intrinsics.baseline > 0;
  if (options.stereo || (!has_depth && !named && fs::is_directory(right))) {
    if (!fs::is_directory(right)) throw FileError(right.string() + ": no such folder (needed for stereo)");
    if (!has_baseline) throw FileError(calibration.string() + ": baseline must be > 0 for stereo");
    for (RecordingEntry& entry : recording.entries) entry.right = same_frame(right, entry);
    recording.depth_source = dot::DepthSource::Stereo;
    return;
  }
  if (!has_depth) throw FileError(depth.string() + ": no such folder");
  for (RecordingEntry& entry : recording.entries) entry.depth = same_frame(depth, entry);
  recording.depth_source = stated.value_or(has_baseline ? dot::DepthSource::Stereo : dot::DepthSource::Unknown);
}

}  // namespace runner
