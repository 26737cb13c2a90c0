// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/opencv.hpp"
#include "dot/kernel/portable_kernels.hpp"

#include <opencv2/imgproc.hpp>

DOT_BEGIN_NAMESPACE

/// Luminance of an image of any colour format, 8 bit.
inline void to_grey(const ImageRef& image, Image<std::uint8_t>& grey) {
  grey.resize(image.width, image.height);
  cv::Mat out = mat(grey.view());
  const auto in = [&](int type) {
    return cv::Mat(image.height, image.width, type, const_cast<void*>(image.data),
                   static_cast<std::size_t>(image.stride));
  };
  switch (image.format) {
    case PixelFormat::Bgr8: cv::cvtColor(in(CV_8UC3), out, cv::COLOR_BGR2GRAY); break;
    case PixelFormat::Rgb8: cv::cvtColor(in(CV_8UC3), out, cv::COLOR_RGB2GRAY); break;
    case PixelFormat::Bgra8: cv::cvtColor(in(CV_8UC4), out, cv::COLOR_BGRA2GRAY); break;
    default: in(CV_8UC1).copyTo(out);
  }
}

/// Inverse depth in 1/m; 0 where there is no measurement: zero, negative, NaN, infinite or beyond `max_depth` metres.
inline void to_inverse_depth(const ImageRef& depth, double max_depth, Image<float>& inverse_depth,
                             const kernel::Kernels& kernels = portable_kernels()) {
  inverse_depth.resize(depth.width, depth.height);
  const bool words = depth.format == PixelFormat::DepthU16;
  const double units_per_metre = words ? depth.depth_units_per_metre : 1;
  const kernel::DepthUnits units{static_cast<float>(units_per_metre), static_cast<float>(1e-3 * units_per_metre),
                                 static_cast<float>(max_depth * units_per_metre)};
  for (int y = 0; y < depth.height; ++y) {
    const void* row = static_cast<const unsigned char*>(depth.data) + y * depth.stride;
    if (words)
      kernels.invert_words(static_cast<const std::uint16_t*>(row), depth.width, units, inverse_depth.row(y));
    else
      kernels.invert_floats(static_cast<const float*>(row), depth.width, units, inverse_depth.row(y));
  }
}

DOT_END_NAMESPACE
