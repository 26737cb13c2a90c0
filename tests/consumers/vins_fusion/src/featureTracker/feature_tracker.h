// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <opencv2/opencv.hpp>
#include <vector>

#include "parameters.h"
// snippet: vins_include
// end of snippet

using namespace std;

// snippet: vins_rectifier
// end of snippet

// Follows corners and looks for new ones. Depth, velocity and the right image's corners are left out.
class FeatureTracker {
 public:
  FeatureTracker() : n_id(0) {}
  void trackImage(double _cur_time, const cv::Mat& _img, const cv::Mat& _img1);
  void setMask();

  // snippet: vins_members
  // end of snippet

  int row, col;
  cv::Mat mask, prev_img, cur_img;
  vector<cv::Point2f> n_pts, prev_pts, cur_pts;
  vector<int> ids, track_cnt;
  vector<CameraPtr> m_camera;
  double cur_time;
  int n_id;
};

class Estimator {
 public:
  void inputImage(double t, const cv::Mat& _img, const cv::Mat& _img1) { featureTracker.trackImage(t, _img, _img1); }
  FeatureTracker featureTracker;
};
