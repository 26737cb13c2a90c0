// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef ORBEXTRACTOR_H
#define ORBEXTRACTOR_H

#include <opencv2/core/core.hpp>
#include <opencv2/features2d/features2d.hpp>
#include <vector>

namespace ORB_SLAM2 {

// Corners on a pyramid, spread over the image. No descriptors: nothing here matches them.
class ORBextractor {
 public:
  ORBextractor(int nfeatures, float scaleFactor, int nlevels, int iniThFAST, int minThFAST);

  // The second argument is there and not used, as in the original.
  void operator()(const cv::Mat& image, const cv::Mat& mask, std::vector<cv::KeyPoint>& keypoints);

  // snippet: orb_extractor_h
  // end of snippet

 protected:
  void ComputePyramid(const cv::Mat& image);
  void ComputeKeyPointsOctTree(std::vector<std::vector<cv::KeyPoint>>& allKeypoints);

  int nfeatures;
  int nlevels;
  int iniThFAST;
  int minThFAST;
  std::vector<int> mnFeaturesPerLevel;
  std::vector<float> mvScaleFactor;
  std::vector<cv::Mat> mvImagePyramid;
};

}  // namespace ORB_SLAM2

#endif
