// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/core.hpp>

#include "rtabmap/core/CameraModel.h"

// What the guide uses of RTAB-Map, written anew: odometry and map keep the last depth, which the test looks at.
namespace rtabmap {

class SensorData {
 public:
  SensorData(const cv::Mat& rgb, const cv::Mat& depth, const CameraModel&, int id, double stamp)
      : depth_(depth), id_(id), stamp_(stamp) {
    CV_Assert(rgb.size() == depth.size());
  }
  cv::Mat depthRaw() const { return depth_; }
  int id() const { return id_; }
  double stamp() const { return stamp_; }

 private:
  cv::Mat depth_;
  int id_;
  double stamp_;
};

struct Transform {
  bool isNull() const { return false; }
};

struct Odometry {
  Transform process(SensorData&) { return {}; }
};

struct Rtabmap {
  bool process(const SensorData& data, const Transform&) {
    depth = data.depthRaw();
    return true;
  }
  cv::Mat depth;
};

}  // namespace rtabmap
