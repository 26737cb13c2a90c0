// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "Frame.h"

#include <thread>

namespace ORB_SLAM2 {

namespace {

void Extract(ORBextractor* extractor, const cv::Mat* image, std::vector<cv::KeyPoint>* keys) {
  (*extractor)(*image, cv::Mat(), *keys);
}

}  // namespace

Frame::Frame(const cv::Mat& imLeft, const cv::Mat& imRight, ORBextractor* extractorLeft, ORBextractor* extractorRight) {
  std::thread threadLeft(Extract, extractorLeft, &imLeft, &mvKeys);
  std::thread threadRight(Extract, extractorRight, &imRight, &mvKeysRight);
  threadLeft.join();
  threadRight.join();
  mvDepth.assign(mvKeys.size(), -1);
}

Frame::Frame(const cv::Mat& imGray, const cv::Mat& imDepth, ORBextractor* extractor) {
  CV_Assert(imDepth.type() == CV_32FC1);
  Extract(extractor, &imGray, &mvKeys);
  for (size_t i = 0; i < mvKeys.size(); ++i) {
    const float d = imDepth.at<float>(mvKeys[i].pt);
    mvDepth.push_back(d > 0 ? d : -1);
  }
}

}  // namespace ORB_SLAM2
