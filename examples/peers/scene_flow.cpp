// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "scene_flow.hpp"

#include <opencv2/video/tracking.hpp>
#include <utility>

#include "ballot.hpp"
#include "geometry.hpp"

namespace peers {

Answers SceneFlowRule::next(const View& view) {
  constexpr int grid = 2;  // pixels between points
  constexpr int least_points = 10;
  const std::optional<View> before = std::exchange(before_, view);
  if (!before) return {};
  cv::Mat flow;
  cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM)->calc(before->grey, view.grey, flow);

  Ballot ballot;
  struct Depths {
    double sum = 0;
    int count = 0;
  };
  std::map<std::uint32_t, Depths> depths;
  for (int y = 0; y < flow.rows; y += grid) {
    for (int x = 0; x < flow.cols; x += grid) {
      const int id = before->ids.at<int>(y, x);
      const float depth = before->depth.at<float>(y, x);
      if (id == 0 || !(depth > 0)) continue;
      const auto& d = flow.at<cv::Vec2f>(y, x);
      const cv::Point2d to(x + double{d[0]}, y + double{d[1]});
      const cv::Point pixel = nearest(to);
      if (!inside(view.ids, pixel) || view.ids.at<int>(pixel) != id || !(view.depth.at<float>(pixel) > 0)) continue;
      const Eigen::Vector3d from_world = before->T_world_camera * point_of(camera_, x, y, depth);
      const Eigen::Vector3d to_world = view.T_world_camera * point_of(camera_, to.x, to.y, view.depth.at<float>(pixel));
      ballot.add(id, (to_world - from_world).norm() > settings_.metres_a_frame);
      Depths& of_object = depths[static_cast<std::uint32_t>(id)];
      of_object.sum += view.depth.at<float>(pixel);
      ++of_object.count;
    }
  }
  Answers answers = ballot.result(settings_.moving_share, least_points);
  for (const auto& [id, of_object] : depths)
    if (of_object.sum > settings_.farthest * of_object.count) answers.erase(id);
  return answers;
}

}  // namespace peers
