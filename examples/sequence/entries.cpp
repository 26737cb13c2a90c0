// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "entries.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>

#include "errors.hpp"
#include "plausible.hpp"
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

void list_coco(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const auto coco = std::make_shared<const CocoMasks>(path);
  bool any = false;
  for (RecordingEntry& entry : entries) {
    if (!coco->has(image_name(entry))) continue;
    any = true;
    entry.masks = path;
    entry.coco = coco;
  }
  if (!any) throw FileError(path.string() + ": has no image of these frames, such as " + image_name(entries[0]));
}

}  // namespace

bool is_there(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (!fs::status_known(status)) throw FileError(path.string() + ": cannot be read: " + error.message());
  return fs::exists(status);
}

std::vector<fs::path> list_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error))
    files.push_back(file->path());
  if (error) throw FileError(folder.string() + ": the folder cannot be read: " + error.message());
  return files;
}

std::vector<RecordingEntry> list_images(const fs::path& folder, const std::string& prefix) {
  std::vector<RecordingEntry> entries;
  if (!fs::is_directory(folder)) throw FileError(folder.string() + ": no such folder");
  for (const fs::path& file : list_files(folder)) {
    const std::optional<int> number = frame_number(file.stem().string(), prefix);
    if (!number || !is_image(file)) continue;
    entries.emplace_back();
    entries.back().number = *number;
    entries.back().image = file;
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

std::string image_name(const RecordingEntry& entry) {
  return is_video(entry.image) ? frame_name(entry.number) : entry.image.filename().string();
}

fs::path same_frame(const fs::path& folder, const RecordingEntry& entry) {
  const std::string stem = fs::path(image_name(entry)).stem().string();
  const std::string six_digits = frame_name(entry.number, "");
  for (const std::string& name : {stem + ".png", stem + ".jpg", six_digits + ".png", six_digits + ".jpg"})
    if (is_there(folder / name)) return folder / name;
  return folder / (stem + ".png");
}

void read_times(const fs::path& path, std::vector<RecordingEntry>& entries, bool plausible) {
  set_times(path, read_table(path, 1), entries, plausible);
}

void set_times(const fs::path& path, const std::vector<Row>& rows, std::vector<RecordingEntry>& entries,
               bool plausible) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Row& row = rows[row_of(path, rows.size(), entries.size(), i, entries[i].number)];
    const Place place{path, row.line};
    entries[i].timestamp = plausible ? in_range(place, "the time", row.values[0], times) : row.values[0];
    if (plausible && i > 0) check_step(place, entries[i - 1].timestamp, entries[i].timestamp);
  }
}

void read_poses(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const std::vector<Row> rows = read_table(path, 12);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Row& row = rows[row_of(path, rows.size(), entries.size(), i, entries[i].number)];
    entries[i].truth.camera = rigid_pose({path, row.line}, row.values.data());
  }
}

bool list_masks(const SequenceOptions& options, std::vector<RecordingEntry>& entries) {
  if (!options.masks) return false;
  const fs::path folder = options.folder / options.mask_dir;
  if (!is_there(folder)) {
    if (options.mask_dir != SequenceOptions{}.mask_dir) throw FileError(folder.string() + ": no such folder");
    return false;
  }
  if (folder.extension() == ".json" && !fs::is_directory(folder)) {
    list_coco(folder, entries);
    return true;
  }
  list_files(folder);  // one that cannot be read is no reason to go without masks
  bool any = false;
  for (RecordingEntry& entry : entries) {
    const fs::path masks = same_frame(folder, entry);
    if (!is_there(masks)) continue;
    any = true;
    entry.masks = masks;
    const fs::path list = fs::path(masks).replace_extension(".csv");
    if (is_there(list)) entry.instances = list;
  }
  if (!any)
    throw FileError(folder.string() + ": holds no masks of these frames, such as " +
                    fs::path(image_name(entries[0])).stem().string() + ".png");
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
