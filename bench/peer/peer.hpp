// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/rgbd/depth.hpp>

#include "dot/camera/intrinsics.hpp"
#include "dot/lie/se3.hpp"

namespace dot::bench {

/// OpenCV's dense odometry, Steinbruecker et al. 2011. Images CV_8UC1, depth CV_32FC1 in metres, 0 or NaN = none; masks
/// CV_8UC1, non-zero = may be used, or empty.
class Peer {
 public:
  using Frame = cv::Ptr<cv::rgbd::OdometryFrame>;

  /// Beyond these it sees or accepts nothing: metres, metres, metres, degrees. Its own defaults are 4 m, 0.07 m, 0.15 m
  /// and 15 degrees.
  struct Limits {
    double depth = 10, depth_difference = 0.07, translation = 0.15, rotation = 15;
    double pixels = 0.07;  ///< share of the pixels that it uses
  };

  Peer(const Intrinsics& camera, const Limits& limits) {
    const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    odometry_ = cv::rgbd::RgbdOdometry::create(cv::Mat(K), 0.f, static_cast<float>(limits.depth));
    odometry_->setMaxDepthDiff(limits.depth_difference);
    odometry_->setMaxPointsPart(limits.pixels);
    odometry_->setMaxTranslation(limits.translation);
    odometry_->setMaxRotation(limits.rotation);
  }

  /// @return whether it reports success; only then `T_cur_ref` is set.
  bool align(const cv::Mat& reference, const cv::Mat& reference_depth, const cv::Mat& reference_mask,
             const cv::Mat& current, const cv::Mat& current_depth, const cv::Mat& current_mask, SE3d& T_cur_ref) {
    cv::Mat Rt;
    const bool ok =
        odometry_->compute(reference, reference_depth, reference_mask, current, current_depth, current_mask, Rt);
    return ok && pose(Rt, T_cur_ref);
  }

  /// What it can compute about a frame before it knows the other, for both roles.
  Frame prepare(const cv::Mat& image, const cv::Mat& depth) {
    Frame frame = cv::rgbd::OdometryFrame::create(image, depth);
    odometry_->prepareFrameCache(frame, cv::rgbd::OdometryFrame::CACHE_ALL);
    return frame;
  }
  bool align(Frame& reference, Frame& current, SE3d& T_cur_ref) {
    cv::Mat Rt;
    return odometry_->compute(reference, current, Rt) && pose(Rt, T_cur_ref);
  }

 private:
  static bool pose(const cv::Mat& Rt, SE3d& T) {
    if (Rt.rows != 4 || Rt.cols != 4 || Rt.type() != CV_64FC1) return false;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) T.R(r, c) = Rt.at<double>(r, c);
      T.t[r] = Rt.at<double>(r, 3);
    }
    return true;
  }

  cv::Ptr<cv::rgbd::RgbdOdometry> odometry_;
};

}  // namespace dot::bench
