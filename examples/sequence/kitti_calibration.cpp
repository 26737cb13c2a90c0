// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "kitti_calibration.hpp"

#include <optional>

#include "errors.hpp"
#include "text.hpp"

namespace runner {

namespace {

struct Projection {
  double fx = 0, fy = 0, cx = 0, cy = 0;
  Eigen::Vector3d t;
};

Projection read_projection(const std::filesystem::path& path, const std::string& key) {
  const std::vector<double> P = read_calibration(path, key, 12);
  if (!(P[0] > 0 && P[5] > 0)) throw FileError(path.string() + ": " + key + ": focal lengths must be > 0");
  Projection p{P[0], P[5], P[2], P[6], {}};
  p.t = {(P[3] - p.cx * P[11]) / p.fx, (P[7] - p.cy * P[11]) / p.fy, P[11]};
  return p;
}

}  // namespace

std::vector<double> read_calibration(const std::filesystem::path& path, const std::string& key, std::size_t count) {
  const std::string heading = key + ":";
  int line_number = 0;
  for (const std::string& line : read_lines(path)) {
    ++line_number;
    const std::vector<std::string> fields = words(line);
    if (fields.empty() || fields[0] != heading) continue;
    const std::string where = path.string() + ": line " + std::to_string(line_number);
    if (fields.size() != count + 1)
      throw FileError(where + " has " + std::to_string(fields.size() - 1) + " numbers, must have " +
                      std::to_string(count));
    std::vector<double> numbers;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const std::optional<double> number = parse_number(fields[i]);
      if (!number) throw FileError(where + ": '" + fields[i] + "' is not a number");
      numbers.push_back(*number);
    }
    return numbers;
  }
  throw FileError(path.string() + ": has no line '" + heading + "'");
}

KittiRig read_rig(const std::filesystem::path& path, const std::string& left, const std::string& right,
                  cv::Size image) {
  const Projection l = read_projection(path, left);
  const Projection r = read_projection(path, right);
  return {{l.fx, l.fy, l.cx, l.cy, image.width, image.height, l.t.x() - r.t.x()}, l.t};
}

}  // namespace runner
