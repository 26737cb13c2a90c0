// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "recording.hpp"

#include "errors.hpp"

namespace runner {

std::size_t row_of(const std::filesystem::path& path, std::size_t rows, std::size_t frames, std::size_t index,
                   int number) {
  if (rows == frames) return index;
  if (static_cast<std::size_t>(number) < rows) return static_cast<std::size_t>(number);
  throw FileError(path.string() + ": has " + std::to_string(rows) + " lines for " + std::to_string(frames) + " frames");
}

Eigen::Matrix4d pose_from_row_major(const double* values) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose.topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values);
  return pose;
}

}  // namespace runner
