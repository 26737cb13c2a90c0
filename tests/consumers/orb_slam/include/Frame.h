// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef FRAME_H
#define FRAME_H

#include <opencv2/core/core.hpp>
#include <vector>

#include "ORBextractor.h"

namespace ORB_SLAM2 {

// The features of one pair of pictures. Matching is left out.
class Frame {
 public:
  Frame() {}
  // Stereo: both extractors at once, each in a thread.
  Frame(const cv::Mat& imLeft, const cv::Mat& imRight, ORBextractor* extractorLeft, ORBextractor* extractorRight);
  // RGB-D: depth CV_32F, metres
  Frame(const cv::Mat& imGray, const cv::Mat& imDepth, ORBextractor* extractor);

  std::vector<cv::KeyPoint> mvKeys, mvKeysRight;
  std::vector<float> mvDepth;  // metres, -1 = unknown
};

}  // namespace ORB_SLAM2

#endif
