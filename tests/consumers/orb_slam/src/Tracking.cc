// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "Tracking.h"

#include <cmath>
#include <opencv2/imgproc/imgproc.hpp>

#include "System.h"

using namespace std;

namespace ORB_SLAM2 {

namespace {

void ToGray(cv::Mat& image, bool rgb) {
  if (image.channels() == 3)
    cvtColor(image, image, rgb ? cv::COLOR_RGB2GRAY : cv::COLOR_BGR2GRAY);
  else if (image.channels() == 4)
    cvtColor(image, image, rgb ? cv::COLOR_RGBA2GRAY : cv::COLOR_BGRA2GRAY);
}

}  // namespace

Tracking::Tracking(const string& strSettingPath, int sensor) : mSensor(sensor), mpORBextractorRight(NULL) {
  cv::FileStorage fSettings(strSettingPath, cv::FileStorage::READ);
  mK = cv::Mat::eye(3, 3, CV_32F);
  mK.at<float>(0, 0) = fSettings["Camera.fx"];
  mK.at<float>(1, 1) = fSettings["Camera.fy"];
  mK.at<float>(0, 2) = fSettings["Camera.cx"];
  mK.at<float>(1, 2) = fSettings["Camera.cy"];
  mDistCoef = cv::Mat::zeros(4, 1, CV_32F);
  mDistCoef.at<float>(0) = fSettings["Camera.k1"];
  mDistCoef.at<float>(1) = fSettings["Camera.k2"];
  mDistCoef.at<float>(2) = fSettings["Camera.p1"];
  mDistCoef.at<float>(3) = fSettings["Camera.p2"];
  mbf = fSettings["Camera.bf"];
  mbRGB = static_cast<int>(fSettings["Camera.RGB"]) != 0;
  mDepthMapFactor = 1 / static_cast<float>(fSettings["DepthMapFactor"]);

  const int nFeatures = fSettings["ORBextractor.nFeatures"];
  const float fScaleFactor = fSettings["ORBextractor.scaleFactor"];
  const int nLevels = fSettings["ORBextractor.nLevels"];
  const int fIniThFAST = fSettings["ORBextractor.iniThFAST"];
  const int fMinThFAST = fSettings["ORBextractor.minThFAST"];
  mpORBextractorLeft = new ORBextractor(nFeatures, fScaleFactor, nLevels, fIniThFAST, fMinThFAST);
  if (sensor == System::STEREO)
    mpORBextractorRight = new ORBextractor(nFeatures, fScaleFactor, nLevels, fIniThFAST, fMinThFAST);
}

// snippet: orb_grab_stereo
cv::Mat Tracking::GrabImageStereo(const cv::Mat& imRectLeft, const cv::Mat& imRectRight, const double& timestamp)
// end of snippet
{
  mImGray = imRectLeft;
  cv::Mat imGrayRight = imRectRight;
  ToGray(mImGray, mbRGB);
  ToGray(imGrayRight, mbRGB);

  // snippet: orb_grab_stereo_mask
  // end of snippet
  mCurrentFrame = Frame(mImGray, imGrayRight, mpORBextractorLeft, mpORBextractorRight);
  return cv::Mat();
}

// snippet: orb_grab_rgbd
cv::Mat Tracking::GrabImageRGBD(const cv::Mat& imRGB, const cv::Mat& imD, const double& timestamp)
// end of snippet
{
  mImGray = imRGB;
  cv::Mat imDepth = imD;
  ToGray(mImGray, mbRGB);
  if (fabs(mDepthMapFactor - 1.0f) > 1e-5 || imDepth.type() != CV_32F) {
    imDepth.convertTo(imDepth, CV_32F, mDepthMapFactor);
  }

  // snippet: orb_grab_rgbd_mask
  // end of snippet
  mCurrentFrame = Frame(mImGray, imDepth, mpORBextractorLeft);
  return cv::Mat();
}

}  // namespace ORB_SLAM2
