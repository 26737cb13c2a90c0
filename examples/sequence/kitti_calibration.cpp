// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_calibration.hpp"

#include <cmath>

#include "errors.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {

namespace {

struct Projection {
  dot::Intrinsics camera;
  Eigen::Vector3d t;
  int line = 0;
};

/// P = K [I t], K without skew.
Projection read_projection(const std::filesystem::path& path, const std::string& key, cv::Size image) {
  constexpr double rounding = 1e-6;
  const Row row = read_calibration(path, key, 12);
  const std::vector<double>& P = row.values;
  const Place place{path, row.line};
  for (const std::size_t i : {1U, 4U, 8U, 9U, 10U})
    if (std::abs(P[i] - (i == 10 ? 1 : 0)) > rounding)
      fail(place, key + " must be 'fx 0 cx . 0 fy cy . 0 0 1 .', the projection of a rectified camera");
  Projection p{{P[0], P[5], P[2], P[6], image.width, image.height, 0}, {}, row.line};
  check_intrinsics(place, p.camera);
  p.t = {(P[3] - P[2] * P[11]) / P[0], (P[7] - P[6] * P[11]) / P[5], P[11]};
  check_position(place, p.t);
  return p;
}

}  // namespace

Row read_calibration(const std::filesystem::path& path, const std::string& key, std::size_t count) {
  const std::string heading = key + ":";
  Place place{path};
  for (const std::string& line : read_lines(path)) {
    ++place.line;
    const std::vector<std::string> fields = words(line);
    if (fields.empty() || fields[0] != heading) continue;
    if (fields.size() != count + 1)
      fail(place, "has " + std::to_string(fields.size() - 1) + " numbers, must have " + std::to_string(count));
    Row row{place.line, {}};
    for (std::size_t i = 1; i < fields.size(); ++i) row.values.push_back(to_number(place, key, fields[i]));
    return row;
  }
  throw FileError(path.string() + ": has no line '" + heading + "'");
}

KittiRig read_rig(const std::filesystem::path& path, const std::string& left, const std::string& right,
                  cv::Size image) {
  constexpr double same = 1e-3;  // of the focal length
  const Projection l = read_projection(path, left, image);
  const Projection r = read_projection(path, right, image);
  const Place place{path, r.line};
  const Eigen::Vector4d K_left(l.camera.fx, l.camera.fy, l.camera.cx, l.camera.cy);
  const Eigen::Vector4d K_right(r.camera.fx, r.camera.fy, r.camera.cx, r.camera.cy);
  if ((K_left - K_right).cwiseAbs().maxCoeff() > same * l.camera.fx)
    fail(place, right + " has other focal lengths or another centre than " + left + ", as no rectified pair has");
  KittiRig rig{l.camera, l.t};
  rig.intrinsics.baseline = in_range(place, "the baseline from " + left + " to " + right, l.t.x() - r.t.x(), baselines);
  return rig;
}

}  // namespace runner
