// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef SYSTEM_H
#define SYSTEM_H

#include <opencv2/core/core.hpp>
#include <string>
#include <vector>

namespace ORB_SLAM2 {

class Tracking;

// The host's front. As in the original its Tracking is made and never deleted.
class System {
 public:
  enum eSensor { MONOCULAR = 0, STEREO = 1, RGBD = 2 };

  System(const std::string& strSettingsFile, eSensor sensor);

  // snippet: orb_system_h
  cv::Mat TrackStereo(const cv::Mat& imLeft, const cv::Mat& imRight, const double& timestamp);
  cv::Mat TrackRGBD(const cv::Mat& im, const cv::Mat& depthmap, const double& timestamp);
  // end of snippet

  // snippet: orb_late_h
  // end of snippet

  void Shutdown();
  std::vector<cv::KeyPoint> GetTrackedKeyPointsUn();

 private:
  eSensor mSensor;
  Tracking* mpTracker;
};

}  // namespace ORB_SLAM2

#endif
