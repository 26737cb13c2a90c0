// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/core.hpp>

// What the guide uses of RTAB-Map, written anew.
namespace rtabmap {

class CameraModel {
 public:
  CameraModel(double fx, double fy, double cx, double cy, const cv::Size& size)
      : fx_(fx), fy_(fy), cx_(cx), cy_(cy), size_(size) {}
  double fx() const { return fx_; }
  double fy() const { return fy_; }
  double cx() const { return cx_; }
  double cy() const { return cy_; }
  int imageWidth() const { return size_.width; }
  int imageHeight() const { return size_.height; }

 private:
  double fx_, fy_, cx_, cy_;
  cv::Size size_;
};

}  // namespace rtabmap
