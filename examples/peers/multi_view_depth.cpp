// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "multi_view_depth.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "ballot.hpp"
#include "geometry.hpp"

namespace peers {
namespace {

/// Whether the depth changes by more than `limit` around each pixel, 255 or 0. No measurement is no change.
cv::Mat borders(const cv::Mat& depth, double limit) {
  const cv::Mat window = cv::Mat::ones(5, 5, CV_8UC1);
  cv::Mat nearest, farthest, filled = depth.clone();
  filled.setTo(1e6F, depth <= 0);
  cv::erode(filled, nearest, window);
  cv::dilate(depth, farthest, window);
  return farthest - nearest > limit;
}

}  // namespace

Answers MultiViewDepthRule::next(const View& view) {
  constexpr int grid = 4;  // pixels between points
  constexpr int least_points = 5;
  const cv::Mat border = borders(view.depth, settings_.metres);
  const dot::SE3d T_camera_world = view.T_world_camera.inverse();
  const double least_cosine = std::cos(settings_.parallax_degrees * CV_PI / 180);
  Ballot ballot;
  for (const View& keyframe : keyframes_) {
    const dot::SE3d T_view_key = T_camera_world * keyframe.T_world_camera;
    for (int y = 0; y < keyframe.depth.rows; y += grid) {
      for (int x = 0; x < keyframe.depth.cols; x += grid) {
        const float depth = keyframe.depth.at<float>(y, x);
        if (!(depth > 0)) continue;
        const Eigen::Vector3d X_key = point_of(camera_, x, y, depth), X = T_view_key * X_key;
        if (!(X.z() > 0)) continue;
        const Eigen::Vector3d from_key = T_view_key.R * X_key;
        if (from_key.dot(X) < least_cosine * from_key.norm() * X.norm()) continue;
        const cv::Point pixel = nearest(pixel_of(camera_, X));
        if (!inside(view.ids, pixel)) continue;
        const int id = view.ids.at<int>(pixel);
        const float measured = view.depth.at<float>(pixel);
        if (id == 0 || !(measured > 0) || border.at<std::uint8_t>(pixel) != 0) continue;
        ballot.add(id, X.z() - measured > settings_.metres);
      }
    }
  }
  if (count_++ % settings_.keyframe_every == 0) keyframes_.push_back(view);
  if (keyframes_.size() > settings_.keyframes) keyframes_.pop_front();
  return ballot.result(settings_.moving_share, least_points);
}

}  // namespace peers
