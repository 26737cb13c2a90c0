// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "dot/camera/intrinsics.hpp"

namespace runner {

/// Depth from a rectified stereo pair by semi-global matching.
class StereoDepth {
 public:
  explicit StereoDepth(const dot::Intrinsics& camera);

  /// Depth of the left image, CV_32FC1 in metres; 0 where the two images do not agree on one.
  /// @param left, right 8-bit, grey or colour, of the camera's size.
  cv::Mat compute(const cv::Mat& left, const cv::Mat& right);

 private:
  cv::Mat match(const cv::Mat& left, const cv::Mat& right);

  double fx_baseline_ = 0;
  int disparities_ = 0;
  cv::Ptr<cv::StereoSGBM> matcher_;
};

}  // namespace runner
