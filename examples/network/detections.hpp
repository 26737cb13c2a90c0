// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "classes.hpp"
#include "run/segmentation.hpp"

namespace network {

/// One instance that a network has found.
struct Detection {
  int class_index = 0;  ///< of the list of classes
  float score = 0;
  cv::Rect region;  ///< pixels of the image
  cv::Mat mask;     ///< CV_8UC1 of the region's size, 255 = the instance
};

/// How sure a network must be.
struct Threshold {
  float score = 0.25F;
  float overlap = 0.45F;  ///< IoU above which the less sure of two boxes of a class goes
  int most = 300;         ///< instances that are left then; the surest count
};

/// A map of numbers that covers the image or a part of it, coarser or finer than its pixels. Cell i covers i to i + 1.
struct Grid {
  cv::Mat values;     ///< CV_32FC1
  double x0, x_step;  ///< the point x of the image is at x0 + x_step * x of the grid
  double y0, y_step;
};

/// The pixels whose centre is in the box.
cv::Rect pixels_in(const cv::Rect2d& box);

/// The pixels of the region whose value, interpolated between the centres of the cells, is over the threshold; beyond
/// the grid it is 0. @return CV_8UC1, 0 or 255.
cv::Mat sample(const Grid& grid, const cv::Rect& region, float threshold);

/// An id image with ids 1, 2, ... by decreasing score. Where instances overlap the surest one has the pixel. Instances
/// of ignored classes, and without a pixel of their own, are left out.
runner::Segmentation to_segmentation(std::vector<Detection> detections, const std::vector<Class>& classes,
                                     cv::Size image);

}  // namespace network
