// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "distortion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

namespace runner {
namespace {

Eigen::Vector2d equidistant(const std::array<double, 5>& k, const Eigen::Vector2d& ray) {
  const double radius = ray.norm();
  if (radius < 1e-12) return ray;
  const double t = std::atan(radius), t2 = t * t;
  return ray * (t * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3])))) / radius);
}

Eigen::Vector2d radtan(const std::array<double, 5>& k, const Eigen::Vector2d& ray) {
  const double x = ray.x(), y = ray.y(), r2 = ray.squaredNorm();
  const double g = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
  return {g * x + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x), g * y + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y};
}

}  // namespace

Eigen::Vector2d Distortion::distort(const Eigen::Vector2d& ray) const {
  return model == Model::Equidistant ? equidistant(coefficients, ray) : radtan(coefficients, ray);
}

Undistorter::Undistorter(const dot::Intrinsics& camera, const Distortion& distortion)
    : map_x_(camera.height, camera.width, CV_32FC1), map_y_(camera.height, camera.width, CV_32FC1) {
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d d = distortion.distort({(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy});
      map_x_.at<float>(y, x) = static_cast<float>(camera.fx * d.x() + camera.cx);
      map_y_.at<float>(y, x) = static_cast<float>(camera.fy * d.y() + camera.cy);
    }
  }
}

cv::Mat Undistorter::image(const cv::Mat& image) const {
  cv::Mat result;
  cv::remap(image, result, map_x_, map_y_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

cv::Mat Undistorter::labels(const cv::Mat& labels) const {
  // Not cv::remap: its nearest neighbours are those of coordinates rounded to 1/32 px, and it has no 32-bit integers.
  cv::Mat result = cv::Mat::zeros(labels.size(), labels.type());
  const std::size_t size = labels.elemSize();
  for (int y = 0; y < result.rows; ++y) {
    for (int x = 0; x < result.cols; ++x) {
      const float from_x = std::round(map_x_.at<float>(y, x)), from_y = std::round(map_y_.at<float>(y, x));
      // Written so that what is not a number is outside.
      const bool inside = from_x >= 0 && from_y >= 0 && from_x < static_cast<float>(labels.cols) &&
                          from_y < static_cast<float>(labels.rows);
      if (inside) std::copy_n(labels.ptr(static_cast<int>(from_y), static_cast<int>(from_x)), size, result.ptr(y, x));
    }
  }
  return result;
}

}  // namespace runner
