// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_raw.hpp"

#include <cstddef>
#include <optional>

#include "entries.hpp"
#include "errors.hpp"
#include "images.hpp"
#include "kitti_calibration.hpp"
#include "kitti_oxts.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

/// A drive's calibration is that of its day, which lies in the folder above.
fs::path calibration_file(const fs::path& folder, const char* name) {
  const fs::path above = fs::absolute(folder / "").parent_path().parent_path() / name;
  return !fs::exists(folder / name) && fs::exists(above) ? above : folder / name;
}

/// Seconds since the midnight of "2011-09-26 13:02:25.964389445".
std::optional<double> seconds_of_day(const std::string& line) {
  const std::vector<std::string> date_and_time = words(line);
  if (date_and_time.size() != 2) return std::nullopt;
  const std::vector<std::string> fields = split(date_and_time[1], ':');
  if (fields.size() != 3) return std::nullopt;
  double seconds = 0;
  for (const std::string& field : fields) {
    const std::optional<double> number = parse_number(field);
    if (!number) return std::nullopt;
    seconds = 60 * seconds + *number;
  }
  return seconds;
}

/// A line for each number of the stream, whether its image is there or not. Times count from the first line's midnight.
void read_timestamps(const fs::path& path, std::vector<RecordingEntry>& entries) {
  constexpr double day = 86400;
  std::vector<double> times;
  std::string date;
  double midnight = 0;
  for (const std::string& line : read_lines(path)) {
    if (trim(line).empty()) continue;
    const std::optional<double> seconds = seconds_of_day(line);
    if (!seconds)
      throw FileError(path.string() + ": line " + std::to_string(times.size() + 1) +
                      ": must be like '2011-09-26 13:02:25.964389445'");
    if (!date.empty() && words(line)[0] != date) midnight += day;
    date = words(line)[0];
    times.push_back(midnight + *seconds);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = row_of(path, times.size(), entries.size(), i, entries[i].number);
    entries[i].timestamp = times[row];
    if (i > 0 && !(entries[i].timestamp > entries[i - 1].timestamp))
      throw FileError(path.string() + ": line " + std::to_string(row + 1) + ": times must increase");
  }
}

}  // namespace

bool is_kitti_raw(const fs::path& folder) {
  return fs::is_directory(folder / "image_02" / "data") || fs::is_directory(folder / "image_00" / "data");
}

Recording read_kitti_raw(const SequenceOptions& options) {
  const bool colour = fs::is_directory(options.folder / "image_02" / "data");
  const std::string left = colour ? "02" : "00", right = colour ? "03" : "01";
  const fs::path stream = options.folder / ("image_" + left);
  const fs::path calibration = calibration_file(options.folder, "calib_cam_to_cam.txt");
  Recording recording;
  recording.layout = "KITTI raw";
  recording.entries = list_images(stream / "data");
  const cv::Size size = read_image(recording.entries[0].image).size();
  const KittiRig rig = read_rig(calibration, "P_rect_" + left, "P_rect_" + right, size);
  recording.intrinsics = rig.intrinsics;
  read_timestamps(stream / "timestamps.txt", recording.entries);
  list_masks(options, recording.entries);
  choose_depth(options, options.folder / ("image_" + right) / "data", calibration, {}, recording);
  if (options.truth && fs::is_directory(options.folder / "oxts" / "data")) {
    const OxtsCalibration extrinsics = {calibration, calibration_file(options.folder, "calib_imu_to_velo.txt"),
                                        calibration_file(options.folder, "calib_velo_to_cam.txt"), rig.X_left_0};
    read_oxts(options.folder / "oxts" / "data", extrinsics, recording.entries);
  }
  return recording;
}

}  // namespace runner
