// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <opencv2/core.hpp>

#include "dot/camera/intrinsics.hpp"

namespace peers {

/// The point that a pixel with a depth shows, in the camera's coordinates.
inline Eigen::Vector3d point_of(const dot::Intrinsics& camera, double x, double y, double depth) {
  return {depth * (x - camera.cx) / camera.fx, depth * (y - camera.cy) / camera.fy, depth};
}

/// The pixel that shows a point in front of the camera.
inline cv::Point2d pixel_of(const dot::Intrinsics& camera, const Eigen::Vector3d& X) {
  return {camera.cx + camera.fx * X.x() / X.z(), camera.cy + camera.fy * X.y() / X.z()};
}

/// The nearest pixel.
inline cv::Point nearest(const cv::Point2d& p) {
  return {static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))};
}

inline bool inside(const cv::Mat& image, const cv::Point& p) {
  return p.x >= 0 && p.y >= 0 && p.x < image.cols && p.y < image.rows;
}

}  // namespace peers
