// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "System.h"

#include "Tracking.h"

namespace ORB_SLAM2 {

System::System(const std::string& strSettingsFile, eSensor sensor)
    : mSensor(sensor), mpTracker(new Tracking(strSettingsFile, sensor)) {}

// snippet: orb_system_stereo
cv::Mat System::TrackStereo(const cv::Mat& imLeft, const cv::Mat& imRight, const double& timestamp)
// end of snippet
{
  CV_Assert(mSensor == STEREO);
  // snippet: orb_system_stereo_call
  cv::Mat Tcw = mpTracker->GrabImageStereo(imLeft, imRight, timestamp);
  // end of snippet
  return Tcw;
}

// snippet: orb_system_rgbd
cv::Mat System::TrackRGBD(const cv::Mat& im, const cv::Mat& depthmap, const double& timestamp)
// end of snippet
{
  CV_Assert(mSensor == RGBD);
  // snippet: orb_system_rgbd_call
  cv::Mat Tcw = mpTracker->GrabImageRGBD(im, depthmap, timestamp);
  // end of snippet
  return Tcw;
}

// snippet: orb_late
// end of snippet

void System::Shutdown() {
  // snippet: orb_shutdown
  // end of snippet
}

std::vector<cv::KeyPoint> System::GetTrackedKeyPointsUn() { return mpTracker->mCurrentFrame.mvKeys; }

}  // namespace ORB_SLAM2
