// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <system_error>

#include "config.hpp"
#include "dot/image/opencv.hpp"
#include "dot/lie/se3.hpp"
#include "errors.hpp"
#include "images.hpp"
#include "text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

/// Value / units = metres, in depth/*.png.
constexpr double depth_units_per_metre = 256;

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

/// Line of a per-frame file for the frame at `index`: files hold a line for each image, or, where rgb/ is a part of a
/// longer recording, one for each frame number.
std::size_t row_of(const fs::path& path, std::size_t rows, std::size_t images, std::size_t index, int number) {
  if (rows == images) return index;
  if (static_cast<std::size_t>(number) < rows) return static_cast<std::size_t>(number);
  throw FileError(path.string() + ": has " + std::to_string(rows) + " lines for " + std::to_string(images) + " frames");
}

dot::CameraMotion camera_motion(const dot::SE3d& T_world_prev, const dot::SE3d& T_world_cur) {
  constexpr double sigma_metres = 0.001;
  constexpr double sigma_radians = 0.01 * 3.14159265358979323846 / 180;
  dot::CameraMotion motion;
  motion.T_cur_prev = (T_world_cur.inverse() * T_world_prev).row_major();
  for (std::size_t i = 0; i < 6; ++i) {
    const double sigma = i < 3 ? sigma_metres : sigma_radians;
    motion.covariance[7 * i] = sigma * sigma;
  }
  return motion;
}

std::vector<dot::Instance> read_instances(const fs::path& path, const std::vector<std::string>& always_dynamic) {
  std::vector<dot::Instance> instances;
  int line_number = 0;
  for (const std::string& line : read_lines(path)) {
    ++line_number;
    const std::vector<std::string> fields = split(line, ',');
    if (trim(line).empty() || (line_number == 1 && fields[0] == "id")) continue;
    const std::string where = path.string() + ": line " + std::to_string(line_number);
    if (fields.size() < 2) throw FileError(where + " must be id,class,score");
    dot::Instance instance;
    const std::optional<double> id = parse_number(fields[0]);
    if (!id || *id < 1 || *id > 65535 || *id != static_cast<std::uint32_t>(*id))
      throw FileError(where + ": id '" + fields[0] + "' is not a whole number from 1 to 65535");
    instance.id = static_cast<std::uint32_t>(*id);
    // A class may be a number or a name; the library takes numbers and does not interpret them.
    if (const std::optional<double> number = parse_number(fields[1]); number && std::abs(*number) < 1e9)
      instance.class_id = static_cast<std::int32_t>(*number);
    if (fields.size() > 2) {
      const std::optional<double> score = parse_number(fields[2]);
      if (!score) throw FileError(where + ": score '" + fields[2] + "' is not a number");
      instance.score = static_cast<float>(*score);
    }
    instance.always_dynamic =
        std::find(always_dynamic.begin(), always_dynamic.end(), fields[1]) != always_dynamic.end();
    instances.push_back(instance);
  }
  return instances;
}

}  // namespace

dot::Frame SequenceFrame::frame() const {
  dot::Frame frame;
  frame.id = static_cast<std::uint64_t>(number);
  frame.timestamp = timestamp;
  frame.image = dot::view(image);
  frame.depth = dot::depth_view(depth, depth_units_per_metre);
  if (!ids.empty()) frame.masks = dot::Masks{dot::id_view(ids), {instances.data(), instances.size()}};
  frame.camera_motion = camera_motion;
  return frame;
}

Sequence::Sequence(const Arguments& arguments)
    : folder_(arguments.sequence),
      depth_folder_(folder_ / arguments.depth_dir),
      mask_folder_(folder_ / arguments.mask_dir),
      always_dynamic_(arguments.always_dynamic),
      mask_every_(arguments.mask_every) {
  if (!fs::is_directory(folder_)) throw FileError(folder_.string() + ": no such folder");
  if (arguments.mask_dir != Arguments{}.mask_dir && !fs::is_directory(mask_folder_))
    throw FileError(mask_folder_.string() + ": no such folder");
  read_intrinsics();
  list_images();
  read_times();
  if (!arguments.camera.empty()) read_camera(arguments.camera);
  choose_depth(arguments);
}

void Sequence::read_intrinsics() {
  const fs::path path = folder_ / "intrinsics.txt";
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
  intrinsics_ = {values[0], values[1], values[2], values[3], static_cast<int>(values[4]), static_cast<int>(values[5]),
                 values[6]};
  fps_ = values[7];

  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> line = words(lines[i]);
    if (line.empty()) continue;
    if (line.size() == 2 && line[0] == "depth") stated_source_ = depth_source_by_name(line[1]);
    if (!stated_source_)
      throw FileError(path.string() + ": line " + std::to_string(i + 1) +
                      " must be 'depth stereo', 'depth rgbd', 'depth lidar' or 'depth unknown'");
  }
}

void Sequence::list_images() {
  const fs::path folder = folder_ / "rgb";
  if (!fs::is_directory(folder)) throw FileError(folder.string() + ": no such folder");
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const std::optional<int> number = frame_number(file.path());
    if (number && is_image(file.path())) entries_.push_back({*number, file.path(), 0, {}});
  }
  if (entries_.empty()) throw FileError(folder.string() + ": holds no images such as 000000.png or 000000.jpg");
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.number < b.number; });
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    if (entries_[i].number == entries_[i - 1].number)
      throw FileError(entries_[i].image.string() + ": the same frame as " + entries_[i - 1].image.string());
  }
}

void Sequence::read_times() {
  const fs::path path = folder_ / "times.txt";
  if (!fs::exists(path)) {
    for (Entry& entry : entries_) entry.timestamp = entry.number / fps_;
    return;
  }
  const std::vector<std::vector<double>> rows = read_table(path, 1);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries_.size(), i, entries_[i].number);
    entries_[i].timestamp = rows[row][0];
    if (i > 0 && !(entries_[i].timestamp > entries_[i - 1].timestamp))
      throw FileError(path.string() + ": line " + std::to_string(row + 1) + ": times must increase");
  }
}

void Sequence::read_camera(const fs::path& path) {
  const std::vector<std::vector<double>> rows = read_table(path, 12);
  std::vector<dot::SE3d> poses;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::size_t row = row_of(path, rows.size(), entries_.size(), i, entries_[i].number);
    std::array<double, 12> T_world_camera{};
    std::copy(rows[row].begin(), rows[row].end(), T_world_camera.begin());
    poses.push_back(dot::SE3d::from_row_major(T_world_camera));
    const auto& R = poses.back().R;
    // Files are written with a few digits; anything worse is no rotation.
    if ((R * R.transpose() - dot::Matrix3<double>::Identity()).norm() > 1e-3 || R.determinant() < 0)
      throw FileError(path.string() + ": line " + std::to_string(row + 1) + " is not a rigid motion");
    poses.back() = poses.back().normalized();
    if (i > 0) entries_[i].camera_motion = camera_motion(poses[i - 1], poses[i]);
  }
}

void Sequence::choose_depth(const Arguments& arguments) {
  const bool has_depth = fs::is_directory(depth_folder_);
  const fs::path right = folder_ / "right";
  const bool named = arguments.depth_dir != Arguments{}.depth_dir;
  if (arguments.stereo || (!has_depth && !named && fs::is_directory(right))) {
    if (!fs::is_directory(right)) throw FileError(right.string() + ": no such folder (needed for stereo)");
    if (!(intrinsics_.baseline > 0))
      throw FileError((folder_ / "intrinsics.txt").string() + ": baseline must be > 0 for stereo");
    stereo_.emplace(intrinsics_);
    depth_source_ = dot::DepthSource::Stereo;
  } else {
    if (!has_depth) throw FileError(depth_folder_.string() + ": no such folder");
    depth_source_ = intrinsics_.baseline > 0 ? dot::DepthSource::Stereo : dot::DepthSource::Unknown;
  }
  if (stated_source_ && !stereo_) depth_source_ = *stated_source_;
}

SequenceFrame Sequence::read(int index) {
  const Entry& entry = entries_[static_cast<std::size_t>(index)];
  SequenceFrame frame;
  frame.number = entry.number;
  frame.timestamp = entry.timestamp;
  frame.camera_motion = entry.camera_motion;
  frame.image = read_image(entry.image, image_size());
  if (frame.image.depth() != CV_8U || frame.image.channels() == 2)
    throw FileError(entry.image.string() + ": must be 8-bit grey or colour");
  if (stereo_) {
    const fs::path path = image_path(folder_ / "right", entry.number);
    const cv::Mat right = read_image(path, image_size());
    if (right.depth() != CV_8U || right.channels() == 2)
      throw FileError(path.string() + ": must be 8-bit grey or colour");
    frame.depth = stereo_->compute(frame.image, right);
  } else {
    const fs::path path = depth_folder_ / frame_name(entry.number);
    frame.depth = read_image(path, image_size());
    if (frame.depth.type() != CV_16UC1) throw FileError(path.string() + ": must be a 16-bit grey image");
  }
  if (index % mask_every_ == 0) read_masks(frame);
  return frame;
}

void Sequence::read_masks(SequenceFrame& frame) const {
  const fs::path path = mask_folder_ / frame_name(frame.number);
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return;
  frame.ids = read_image(path, image_size());
  if (frame.ids.type() != CV_8UC1 && frame.ids.type() != CV_16UC1)
    throw FileError(path.string() + ": must be an 8-bit or 16-bit grey image of ids");
  const fs::path list = mask_folder_ / frame_name(frame.number, ".csv");
  if (fs::exists(list)) frame.instances = read_instances(list, always_dynamic_);
}

}  // namespace runner
