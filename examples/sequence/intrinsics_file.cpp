// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "intrinsics_file.hpp"

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "depth_source.hpp"
#include "errors.hpp"
#include "json_value.hpp"
#include "plausible.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

constexpr int largest_side = 65535;
constexpr Range coefficients{-1e3, 1e3};

Distortion read_distortion(const Place& place, const std::vector<std::string>& line) {
  Distortion d;
  const bool radtan = line.size() > 1 && line[1] == "radtan";
  if (!radtan && !(line.size() > 1 && line[1] == "equidistant"))
    fail(place, "must be 'distortion radtan k1 k2 p1 p2 [k3]' or 'distortion equidistant k1 k2 k3 k4'");
  d.model = radtan ? Distortion::Model::RadTan : Distortion::Model::Equidistant;
  const std::size_t count = line.size() - 2;
  if (count != 4 && !(radtan && count == 5))
    fail(place, line[1] + " has " + std::to_string(count) + " coefficients, must have " + (radtan ? "4 or 5" : "4"));
  for (std::size_t i = 0; i < count; ++i)
    d.coefficients[i] = in_range(place, "a coefficient", to_number(place, "a coefficient", line[i + 2]), coefficients);
  return d;
}

CameraFile read_text(const fs::path& path) {
  const char* const names[] = {"fx", "fy", "cx", "cy", "width", "height", "baseline", "fps"};
  const std::vector<std::string> lines = read_lines(path);
  const std::vector<std::string> fields = words(lines.empty() ? "" : lines[0]);
  Place place{path, 1};
  double values[std::size(names)] = {};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (i >= fields.size()) fail(place, std::string(names[i]) + " is missing");
    values[i] = to_number(place, names[i], fields[i]);
  }
  if (fields.size() > std::size(names)) fail(place, "has more than eight numbers");
  CameraFile camera;
  camera.intrinsics = {values[0],
                       values[1],
                       values[2],
                       values[3],
                       to_whole(place, "width", values[4], 1, largest_side),
                       to_whole(place, "height", values[5], 1, largest_side),
                       values[6]};
  check_intrinsics(place, camera.intrinsics);
  camera.fps = in_range(place, "fps", values[7], frame_rates);

  for (std::size_t i = 1; i < lines.size(); ++i) {
    ++place.line;
    const std::vector<std::string> line = words(lines[i]);
    if (line.empty()) continue;
    if (line[0] == "distortion") {
      if (camera.distortion) fail(place, "a second line of the distortion");
      camera.distortion = read_distortion(place, line);
      continue;
    }
    if (camera.stated_source) fail(place, "nothing may follow the line of the depth but that of the distortion");
    if (line.size() == 2 && line[0] == "depth") camera.stated_source = depth_source_by_name(line[1]);
    if (!camera.stated_source) fail(place, "must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'");
  }
  return camera;
}

/// Open3D's: the matrix is column-major, and depths are `depth_scale` to the metre.
CameraFile read_open3d(const fs::path& path) {
  const JsonValue document = read_json(path);
  const auto wrong = [&](const std::string& what) { throw FileError(path.string() + ": " + what); };
  const Place place{path, 1};
  const auto number = [&](const char* name) {
    const JsonValue* value = document.find(name);
    if (value == nullptr || !value->is(JsonValue::Type::Number)) wrong(std::string("has no number '") + name + "'");
    return value->number();
  };
  CameraFile camera;
  const JsonValue* matrix = document.find("intrinsic_matrix");
  if (matrix == nullptr || matrix->array().size() != 9) wrong("has no 'intrinsic_matrix' of nine numbers");
  const std::vector<JsonValue>& m = matrix->array();
  camera.intrinsics = {m[0].number(),
                       m[4].number(),
                       m[6].number(),
                       m[7].number(),
                       to_whole(place, "width", number("width"), 1, largest_side),
                       to_whole(place, "height", number("height"), 1, largest_side),
                       0};
  check_intrinsics(place, camera.intrinsics);
  constexpr double usual_fps = 30;  // that of an Azure Kinect's recording is not in the file
  camera.fps = document.find("fps") != nullptr ? in_range(place, "fps", number("fps"), frame_rates) : usual_fps;
  if (document.find("depth_scale") != nullptr)
    camera.depth_units_per_metre =
        depth_scale<FileError>(path.string() + ": depth_scale", format("%.10g", number("depth_scale")));
  camera.stated_source = dot::DepthSource::Rgbd;
  return camera;
}

}  // namespace

CameraFile read_camera_file(const fs::path& path) {
  return path.extension() == ".json" ? read_open3d(path) : read_text(path);
}

}  // namespace runner
