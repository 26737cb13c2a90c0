// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef TRACKING_H
#define TRACKING_H

#include <opencv2/core/core.hpp>
#include <string>

// snippet: orb_tracking_include
// end of snippet
#include "Frame.h"
#include "ORBextractor.h"

namespace ORB_SLAM2 {

// Makes a Frame of the pictures. Poses and map are left out.
class Tracking {
 public:
  Tracking(const std::string& strSettingPath, int sensor);

  // snippet: orb_tracking_h
  cv::Mat GrabImageStereo(const cv::Mat& imRectLeft, const cv::Mat& imRectRight, const double& timestamp);
  cv::Mat GrabImageRGBD(const cv::Mat& imRGB, const cv::Mat& imD, const double& timestamp);
  // end of snippet

  int mSensor;
  Frame mCurrentFrame;
  cv::Mat mImGray;

 protected:
  ORBextractor *mpORBextractorLeft, *mpORBextractorRight;
  cv::Mat mK;
  cv::Mat mDistCoef;
  float mbf;
  float mDepthMapFactor;
  bool mbRGB;
};

}  // namespace ORB_SLAM2

#endif
