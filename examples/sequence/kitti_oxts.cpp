// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_oxts.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>

#include "kitti_calibration.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

constexpr double radians = 3.14159265358979323846 / 180;

Eigen::Matrix3d read_rotation(const fs::path& path, const std::string& key) {
  const Row row = read_calibration(path, key, 9);
  Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row.values.data());
  check_rotation({path, row.line}, key, R);
  return R;
}

Eigen::Matrix4d transform(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = R;
  T.topRightCorner<3, 1>() = t;
  return T;
}

Eigen::Matrix4d read_transform(const fs::path& path) {
  const Row row = read_calibration(path, "T", 3);
  const Eigen::Vector3d t(row.values.data());
  check_position({path, row.line}, t);
  return transform(read_rotation(path, "R"), t);
}

/// Latitude, longitude, altitude, roll, pitch, yaw.
std::vector<double> read_packet(const fs::path& path) {
  struct Field {
    const char* name;
    Range range;
  };
  // A Mercator map ends before the poles.
  constexpr Range turns{-7, 7};
  constexpr Field layout[] = {{"latitude", {-85, 85}}, {"longitude", {-360, 360}}, {"altitude", {-1e5, 1e5}},
                              {"roll", turns},         {"pitch", turns},           {"yaw", turns}};
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> fields = words(lines.empty() ? "" : lines[0]);
  const Place place{path, 1};
  if (fields.size() < std::size(layout)) fail(place, "must begin with six numbers");
  std::vector<double> packet;
  for (std::size_t i = 0; i < std::size(layout); ++i)
    packet.push_back(in_range(place, layout[i].name, to_number(place, layout[i].name, fields[i]), layout[i].range));
  return packet;
}

Eigen::Matrix4d pose(const std::vector<double>& packet, double scale) {
  constexpr double earth_radius = 6378137;
  const double east = scale * earth_radius * packet[1] * radians;
  const double north = scale * earth_radius * std::log(std::tan((90 + packet[0]) * radians / 2));
  const Eigen::AngleAxisd roll(packet[3], Eigen::Vector3d::UnitX());
  const Eigen::AngleAxisd pitch(packet[4], Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd yaw(packet[5], Eigen::Vector3d::UnitZ());
  Eigen::Matrix4d T_world_imu = Eigen::Matrix4d::Identity();
  T_world_imu.topLeftCorner<3, 3>() = (yaw * pitch * roll).toRotationMatrix();
  T_world_imu.topRightCorner<3, 1>() = Eigen::Vector3d(east, north, packet[2]);
  return T_world_imu;
}

}  // namespace

void read_oxts(const fs::path& folder, const OxtsCalibration& calibration, std::vector<RecordingEntry>& entries) {
  const Eigen::Matrix4d T_rect_cam0 =
      transform(read_rotation(calibration.cam_to_cam, "R_rect_00"), calibration.X_left_0);
  const Eigen::Matrix4d T_left_imu =
      T_rect_cam0 * read_transform(calibration.velo_to_cam) * read_transform(calibration.imu_to_velo);
  const Eigen::Matrix4d T_imu_left = T_left_imu.inverse();
  double scale = 0;
  for (RecordingEntry& entry : entries) {
    char name[32];
    std::snprintf(name, sizeof name, "%010d.txt", entry.number);
    const std::vector<double> packet = read_packet(folder / name);
    if (scale == 0) scale = std::cos(packet[0] * radians);
    entry.truth.camera = pose(packet, scale) * T_imu_left;
  }
}

}  // namespace runner
