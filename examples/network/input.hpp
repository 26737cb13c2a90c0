// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

#include "tensor.hpp"

namespace network {

/// Where an image lies in a network's input: a point x, y of the image is at scale * (x, y) + offset. Both have the
/// corner of their first pixel at 0, 0, so that the centre of pixel i is at i + 0.5.
struct Placement {
  cv::Size image;
  cv::Size input;
  double scale_x = 1;
  double scale_y = 1;
  double offset_x = 0;
  double offset_y = 0;

  /// A box of the input, in the image; x2 and y2 in width and height.
  cv::Rect2d to_image(double x1, double y1, double x2, double y2) const;
};

/// What a network takes its image as.
struct InputForm {
  bool letterbox = false;   ///< keeps the image's proportions, grey borders around; otherwise it fills the input
  bool rgb = true;          ///< or BGR
  double scale = 1 / 255.;  ///< of the 8-bit values
};

/// @param letterbox as YOLO does it: the largest size that fits, in the middle.
Placement place(cv::Size image, cv::Size input, bool letterbox);

/// @param image 8 bit, grey, BGR or BGRA, of the placement's size.
/// @return shape 1x3xHxW.
Tensor make_input(const cv::Mat& image, const Placement& placement, const InputForm& form);

}  // namespace network
