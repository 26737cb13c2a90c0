// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "dot/frame/frame.hpp"

namespace runner {

/// What a network says of one image.
struct Segmentation {
  cv::Mat ids;                           ///< CV_8UC1 or CV_16UC1, of the image's size, 0 = background
  std::vector<dot::Instance> instances;  ///< class and score of some of the ids; may be empty
};

/// Segments an 8-bit grey or BGR image. Throws when it cannot.
using Segmenter = std::function<Segmentation(const cv::Mat& image)>;

}  // namespace runner
