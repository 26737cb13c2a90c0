// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "moved_outlines.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "dot/image/opencv.hpp"
#include "dot/lie/se3.hpp"
#include "dot/statistics/median.hpp"

namespace player {
namespace {

/// T_o over the last interval, axes of the previous camera.
dot::SE3d own_motion(const dot::ObjectResult& object, const dot::Result& result) {
  if (object.reason == dot::Reason::None) return dot::SE3d::from_row_major(object.T_o);
  if (object.last_decided != dot::State::Moving) return {};
  const auto& v = object.fused_velocity;  // in the new camera's axes
  const Eigen::Vector3d velocity(v[0], v[1], v[2]);
  return dot::SE3d::translation(dot::SE3d::from_row_major(result.camera.T_cur_prev).R.transpose() * velocity *
                                result.interval);
}

bool is_known(dot::CameraStatus status) {
  return status == dot::CameraStatus::Tracked || status == dot::CameraStatus::FromHost;
}

/// Of the depths of a region; 0 if there are none. @param inside CV_8UC1.
float median_depth(const cv::Mat& depth, const cv::Mat& inside) {
  std::vector<float> values;
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x)
      if (inside.at<std::uint8_t>(y, x) != 0 && depth.at<float>(y, x) > 0) values.push_back(depth.at<float>(y, x));
  if (values.empty()) return 0;
  return dot::median(values.begin(), values.end());
}

/// The pixels whose centres lie in a square; at least one for size >= 1. @param size pixels.
cv::Rect square(double u, double v, double size) {
  const auto first = [&](double middle) { return static_cast<int>(std::ceil(middle - size / 2)); };
  const auto last = [&](double middle) { return static_cast<int>(std::floor(middle + size / 2)); };
  return {cv::Point(first(u), first(v)), cv::Point(last(u) + 1, last(v) + 1)};
}

}  // namespace

std::map<std::uint32_t, Outlines> MovedOutlines::next(const runner::SequenceFrame& frame, const dot::Result& result) {
  std::map<std::uint32_t, Outlines> outlines;
  if (is_known(result.camera.status)) {
    for (const auto& [id, box] : boxes_)
      if (const dot::ObjectResult* object = result.find(id)) outlines[id] = moved(*object, box, result);
  }
  ids_ = dot::to_mat(result.ids).clone();
  boxes_.clear();
  for (const dot::ObjectResult& object : result.objects) {
    const auto& [x, y, width, height] = object.box;
    if (object.area > 0) boxes_[object.id] = cv::Rect(x, y, width, height);
  }
  const double scale = frame.depth.type() == CV_16UC1 ? 1 / frame.depth_units_per_metre : 1;
  frame.depth.convertTo(depth_, CV_32F, scale);
  return outlines;
}

Outlines MovedOutlines::moved(const dot::ObjectResult& object, const cv::Rect& box, const dot::Result& result) const {
  const cv::Mat inside = ids_(box) == static_cast<double>(object.id);
  const cv::Mat depth = depth_(box);
  const float median = median_depth(depth, inside);
  if (median <= 0) return {};
  const dot::SE3d T_cur_prev = dot::SE3d::from_row_major(result.camera.T_cur_prev) * own_motion(object, result);
  cv::Mat reached(ids_.size(), CV_8UC1, cv::Scalar(0));
  cv::Rect reached_box;
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      if (inside.at<std::uint8_t>(y, x) == 0) continue;
      // No measurement, or one of the scene behind a ragged border: the object's distance.
      float z = depth.at<float>(y, x);
      if (!(z > 0.5F * median && z < 1.5F * median)) z = median;
      const Eigen::Vector3d X((box.x + x - camera_.cx) / camera_.fx * z, (box.y + y - camera_.cy) / camera_.fy * z, z);
      const Eigen::Vector3d moved = T_cur_prev * X;
      if (moved.z() < 0.1) continue;
      const double u = camera_.fx * moved.x() / moved.z() + camera_.cx;
      const double v = camera_.fy * moved.y() / moved.z() + camera_.cy;
      if (!(std::abs(u) < 1e5 && std::abs(v) < 1e5)) continue;
      const cv::Rect pixel =
          square(u, v, std::clamp(static_cast<double>(z) / moved.z(), 1.0, 8.0)) & cv::Rect({0, 0}, reached.size());
      if (pixel.empty()) continue;
      reached(pixel).setTo(255);
      reached_box |= pixel;
    }
  }
  if (reached_box.empty()) return {};
  cv::Mat closed;
  cv::morphologyEx(reached(reached_box), closed, cv::MORPH_CLOSE, cv::Mat::ones(5, 5, CV_8UC1));
  // Holes are mostly gaps between pixels that moved apart.
  return outlines_of(closed, reached_box.tl(), Holes::Fill);
}

}  // namespace player
