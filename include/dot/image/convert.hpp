// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/opencv.hpp"

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
/// @return the number of measurements.
inline int to_inverse_depth(const ImageRef& depth, double max_depth, Image<float>& inverse_depth) {
  inverse_depth.resize(depth.width, depth.height);
  int valid = 0;
  const auto convert = [&](auto view, double units_per_metre) {
    const float unit = static_cast<float>(units_per_metre);
    const float near = static_cast<float>(1e-3 * units_per_metre),
                far = static_cast<float>(max_depth * units_per_metre);
    for (int y = 0; y < depth.height; ++y) {
      const auto* in = view.row(y);
      float* out = inverse_depth.row(y);
      // Divided before it is known whether the value counts: loops without branches become SIMD code.
      for (int x = 0; x < depth.width; ++x) {
        const float value = static_cast<float>(in[x]), inverse = unit / value;
        const bool ok = (value > near) & (value < far);  // false for NaN and infinity
        out[x] = ok ? inverse : 0;
        valid += ok;
      }
    }
  };
  if (depth.format == PixelFormat::DepthU16)
    convert(ImageView<const std::uint16_t>{static_cast<const std::uint16_t*>(depth.data), depth.width, depth.height,
                                           depth.stride},
            depth.depth_units_per_metre);
  else
    convert(ImageView<const float>{static_cast<const float*>(depth.data), depth.width, depth.height, depth.stride}, 1);
  return valid;
}

DOT_END_NAMESPACE
