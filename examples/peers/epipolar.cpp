// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "epipolar.hpp"

#include <Eigen/LU>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <utility>
#include <vector>

#include "ballot.hpp"
#include "dot/lie/so3.hpp"
#include "geometry.hpp"

namespace peers {
namespace {

// As in the published program.
constexpr int border = 5;          // pixels
constexpr int most_change = 2120;  // grey values, sum over the 3x3 surroundings
const cv::Size window(22, 22);
constexpr int levels = 5;

// More and closer corners than the program's, since masks are small.
constexpr int most_corners = 4000;
constexpr double corner_quality = 0.001;
constexpr double corner_distance = 4;

/// Sum of the absolute differences of the surroundings, or more than any where these reach over the border.
int change(const cv::Mat& a, const cv::Point& at_a, const cv::Mat& b, const cv::Point& at_b) {
  const auto near_border = [&](const cv::Point& p) {
    return p.x < border || p.y < border || p.x >= a.cols - border || p.y >= a.rows - border;
  };
  if (near_border(at_a) || near_border(at_b)) return most_change + 1;
  int sum = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      sum +=
          std::abs(int{a.at<std::uint8_t>(at_a + cv::Point(x, y))} - int{b.at<std::uint8_t>(at_b + cv::Point(x, y))});
  return sum;
}

/// How far points are from where a standing scene would have them.
class StandingScene {
 public:
  StandingScene(const dot::Intrinsics& c, const dot::SE3d& T_cur_prev) {
    Eigen::Matrix3d K;
    K << c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1;
    const Eigen::Matrix3d K_inv = K.inverse();
    H_ = K * T_cur_prev.R * K_inv;
    F_ = K_inv.transpose() * dot::so3::hat(T_cur_prev.t) * T_cur_prev.R * K_inv;
    constexpr double standing = 0.005;  // metres; less shifts nothing by a pixel beyond 4 m
    has_lines_ = T_cur_prev.t.norm() > standing;
  }

  double distance(const cv::Point2f& before, const cv::Point2f& now) const {
    const Eigen::Vector3d p(before.x, before.y, 1), q(now.x, now.y, 1);
    if (!has_lines_) return ((H_ * p).hnormalized() - q.head<2>()).norm();
    const Eigen::Vector3d line = F_ * p;
    return std::abs(q.dot(line)) / line.head<2>().norm();
  }

 private:
  Eigen::Matrix3d H_;  ///< takes pixels along with the rotation
  Eigen::Matrix3d F_;
  bool has_lines_ = false;
};

}  // namespace

Answers EpipolarRule::next(const View& view) {
  const std::optional<View> before = std::exchange(before_, view);
  if (!before) return {};
  std::vector<cv::Point2f> from, to;
  cv::goodFeaturesToTrack(before->grey, from, most_corners, corner_quality, corner_distance, before->ids != 0);
  if (from.empty()) return {};
  std::vector<std::uint8_t> found;
  cv::calcOpticalFlowPyrLK(before->grey, view.grey, from, to, found, cv::noArray(), window, levels);

  const StandingScene standing(camera_, view.T_world_camera.inverse() * before->T_world_camera);
  Ballot ballot;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const cv::Point start = nearest(from[i]), end = nearest(to[i]);
    if (found[i] == 0 || change(before->grey, start, view.grey, end) > most_change) continue;
    const int id = before->ids.at<int>(start);
    if (id != 0 && view.ids.at<int>(end) == id) ballot.add(id, standing.distance(from[i], to[i]) > settings_.pixels);
  }
  return ballot.result(settings_.moving_share, 1);
}

}  // namespace peers
