// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_raw.hpp"

#include <string>
#include <vector>

#include "entries.hpp"
#include "images.hpp"
#include "kitti_calibration.hpp"
#include "kitti_oxts.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

/// A drive's calibration is that of its day, which lies in the folder above.
fs::path calibration_file(const fs::path& folder, const char* name) {
  const fs::path above = fs::absolute(folder / "").parent_path().parent_path() / name;
  return !fs::exists(folder / name) && fs::exists(above) ? above : folder / name;
}

/// A day and the seconds since its midnight.
struct Moment {
  std::string date;
  double seconds = 0;
};

/// Of "2011-09-26 13:02:25.964389445".
Moment read_moment(const Place& place, const std::string& line) {
  const std::vector<std::string> date_and_time = words(line);
  const std::vector<std::string> fields = split(date_and_time.size() == 2 ? date_and_time[1] : "", ':');
  const auto is_date = [](const std::string& text) {
    return text.size() == 10 && text[4] == '-' && text[7] == '-' &&
           text.find_first_not_of("0123456789-") == std::string::npos;
  };
  if (fields.size() != 3 || !is_date(date_and_time[0])) fail(place, "must be like '2011-09-26 13:02:25.964389445'");
  const int hours = to_whole(place, "the hour", to_number(place, "the hour", fields[0]), 0, 23);
  const int minutes = to_whole(place, "the minute", to_number(place, "the minute", fields[1]), 0, 59);
  const double seconds = in_range(place, "the second", to_number(place, "the second", fields[2]), {0, 60});
  return {date_and_time[0], 3600.0 * hours + 60.0 * minutes + seconds};
}

/// A line for each number of the stream, whether its image is there or not. Times count from the first line's midnight.
/// @param plausible whether they must increase.
void read_timestamps(const fs::path& path, std::vector<RecordingEntry>& entries, bool plausible) {
  constexpr double day = 86400;
  std::vector<Row> rows;
  std::string date;
  double midnight = 0;
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    if (trim(line).empty()) continue;
    const Moment moment = read_moment(place, line);
    const bool goes_back = moment.date < date;
    if (goes_back && plausible) fail(place, "the date goes back");
    if (!date.empty() && moment.date != date) midnight += goes_back ? -day : day;
    date = moment.date;
    rows.push_back({place.line, {midnight + moment.seconds}});
  }
  set_times(path, rows, entries, plausible);
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
  read_timestamps(stream / "timestamps.txt", recording.entries, options.check_times);
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
