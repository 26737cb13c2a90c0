// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "tum_rgbd.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "dot/lie/se3.hpp"
#include "entries.hpp"
#include "errors.hpp"
#include "images.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

constexpr double depth_units_per_metre = 5000;
constexpr double same_time = 0.02;   // seconds between an image and its depth
constexpr double longest_gap = 0.1;  // seconds between two true poses

struct Calibration {
  const char* folder;  ///< part of its name
  double fx, fy, cx, cy;
};
constexpr Calibration calibrations[] = {{"freiburg1", 517.3, 516.5, 318.6, 255.3},
                                        {"freiburg2", 520.9, 521.0, 325.1, 249.7},
                                        {"freiburg3", 535.4, 539.2, 320.1, 247.6},
                                        {"rgbd_bonn", 542.822841, 542.576870, 315.593520, 237.756098},
                                        {"", 525, 525, 319.5, 239.5}};

dot::Intrinsics intrinsics(const fs::path& folder, cv::Size size) {
  const std::string name = fs::absolute(folder / "").parent_path().filename().string();
  const Calibration& c = *std::find_if(std::begin(calibrations), std::end(calibrations), [&](const Calibration& known) {
    return name.find(known.folder) != std::string::npos;
  });
  return {c.fx, c.fy, c.cx, c.cy, size.width, size.height, 0};
}

/// A line with a time and what belongs to it.
struct Stamped {
  int line = 0;
  double time = 0;
  std::vector<std::string> fields;
};

/// Lines `time field field ...`; those that begin with # are comments.
/// @param plausible whether times must be, and increase.
std::vector<Stamped> read_stamped(const fs::path& path, std::size_t fields, bool plausible = true) {
  std::vector<Stamped> rows;
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    std::vector<std::string> all = words(line);
    if (all.empty() || all[0][0] == '#') continue;
    if (all.size() != fields + 1)
      fail(place, "must be a time and " + std::to_string(fields) + (fields == 1 ? " name" : " numbers"));
    const double time = to_number(place, "the time", all[0]);
    if (plausible) in_range(place, "the time", time, times);
    if (plausible && !rows.empty()) check_step(place, rows.back().time, time);
    rows.push_back({place.line, time, {all.begin() + 1, all.end()}});
  }
  return rows;
}

/// Times and names of files, which must lie in the recording's folder.
std::vector<Stamped> read_names(const fs::path& path, bool plausible) {
  std::vector<Stamped> rows = read_stamped(path, 1, plausible);
  for (const Stamped& row : rows) {
    const fs::path name = row.fields[0];
    const bool printable =
        std::none_of(row.fields[0].begin(), row.fields[0].end(), [](unsigned char c) { return c < ' ' || c == 0x7F; });
    if (!printable || name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end())
      fail({path, row.line}, quoted(row.fields[0]) + " is not the name of a file in this folder");
  }
  return rows;
}

/// The last row at or before a time, and the one after it, of rows in the order of time.
using Neighbours = std::pair<std::vector<Stamped>::const_iterator, std::vector<Stamped>::const_iterator>;
Neighbours around(const std::vector<Stamped>& rows, double time) {
  const auto after =
      std::upper_bound(rows.begin(), rows.end(), time, [](double t, const Stamped& row) { return t < row.time; });
  return {after == rows.begin() ? rows.end() : after - 1, after};
}

/// The image of the nearest time; empty when that is too far away.
fs::path depth_image(const std::vector<Stamped>& depths, double time, const fs::path& folder) {
  const auto [before, after] = around(depths, time);
  auto nearest = before;
  if (before == depths.end() || (after != depths.end() && after->time - time < time - before->time)) nearest = after;
  if (nearest == depths.end() || std::abs(nearest->time - time) > same_time) return {};
  return folder / nearest->fields[0];
}

dot::SE3d pose(const Stamped& row, const fs::path& path) {
  const char* const names[] = {"tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  constexpr Range lengths{0.99, 1.01};  // of a quaternion of three digits
  const Place place{path, row.line};
  double v[std::size(names)] = {};
  for (std::size_t i = 0; i < std::size(names); ++i) v[i] = to_number(place, names[i], row.fields[i]);
  const Eigen::Vector3d t(v[0], v[1], v[2]);
  check_position(place, t);
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  in_range(place, "the quaternion's length", q.norm(), lengths);
  return {q.normalized().toRotationMatrix(), t};
}

void read_truth(const fs::path& path, std::vector<RecordingEntry>& entries) {
  const std::vector<Stamped> rows = read_stamped(path, 7);
  for (const Stamped& row : rows) pose(row, path);  // the lines that no image needs are to be good as well
  for (RecordingEntry& entry : entries) {
    const auto [before, after] = around(rows, entry.timestamp);
    if (before == rows.end()) continue;
    dot::SE3d T = pose(*before, path);
    if (before->time < entry.timestamp) {
      if (after == rows.end() || after->time - before->time > longest_gap) continue;
      T = dot::se3::interpolate(T, pose(*after, path), (entry.timestamp - before->time) / (after->time - before->time));
    }
    entry.truth.camera = pose_from_row_major(T.row_major().data());
  }
}

}  // namespace

bool is_tum_rgbd(const fs::path& folder) { return fs::exists(folder / "rgb.txt") && fs::exists(folder / "depth.txt"); }

Recording read_tum_rgbd(const SequenceOptions& options) {
  if (options.stereo) throw FileError(options.folder.string() + ": a TUM RGB-D recording has no stereo pair");
  std::vector<Stamped> depths = read_names(options.folder / "depth.txt", options.check_times);
  std::stable_sort(depths.begin(), depths.end(), [](const Stamped& a, const Stamped& b) { return a.time < b.time; });
  Recording recording;
  recording.layout = "TUM RGB-D";
  recording.depth_source = dot::DepthSource::Rgbd;
  recording.depth_units_per_metre = depth_units_per_metre;
  int number = 0;
  for (const Stamped& image : read_names(options.folder / "rgb.txt", options.check_times)) {
    RecordingEntry entry;
    entry.number = number++;
    entry.timestamp = image.time;
    entry.image = options.folder / image.fields[0];
    entry.depth = depth_image(depths, image.time, options.folder);
    if (!entry.depth.empty()) recording.entries.push_back(entry);
  }
  if (recording.entries.empty())
    throw FileError((options.folder / "rgb.txt").string() + ": no image has a depth image of its time");
  recording.intrinsics = intrinsics(options.folder, read_image(recording.entries[0].image).size());
  list_masks(options, recording.entries);
  const fs::path truth = options.folder / "groundtruth.txt";
  if (options.truth && fs::exists(truth)) read_truth(truth, recording.entries);
  return recording;
}

}  // namespace runner
