// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "dot/abi.hpp"
#include "dot/camera/depth_bias.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/portable_kernels.hpp"

#include <opencv2/imgproc.hpp>

DOT_BEGIN_NAMESPACE

/// Luminance of the rows of an image of any colour format, 8 bit. The rows are converted on request, in blocks that fit
/// into the cache.
class GreyRows {
 public:
  static constexpr int kAtOnce = 32;  ///< rows

  /// @param rows scratch.
  GreyRows(const ImageRef& image, Image<std::uint8_t>& rows) : image_(image), rows_(rows) {
    if (image.format != PixelFormat::Grey8) rows_.resize(image.width, 2 * kAtOnce);
  }

  /// Row y. It is valid until a row more than kAtOnce below it is requested.
  const std::uint8_t* operator()(int y) {
    if (image_.format == PixelFormat::Grey8) return static_cast<const std::uint8_t*>(image_.data) + y * image_.stride;
    for (; end_ <= y; end_ += kAtOnce) convert(end_, std::min(kAtOnce, image_.height - end_));
    return rows_.row(y % (2 * kAtOnce));
  }

 private:
  void convert(int begin, int count) {
    cv::Mat out(count, image_.width, CV_8UC1, rows_.row(begin % (2 * kAtOnce)));
    const auto in = [&](int type) {
      const auto* first = static_cast<const std::uint8_t*>(image_.data) + begin * image_.stride;
      return cv::Mat(count, image_.width, type, const_cast<std::uint8_t*>(first),
                     static_cast<std::size_t>(image_.stride));
    };
    switch (image_.format) {
      case PixelFormat::Rgb8: cv::cvtColor(in(CV_8UC3), out, cv::COLOR_RGB2GRAY); break;
      case PixelFormat::Bgra8: cv::cvtColor(in(CV_8UC4), out, cv::COLOR_BGRA2GRAY); break;
      default: cv::cvtColor(in(CV_8UC3), out, cv::COLOR_BGR2GRAY);
    }
  }

  ImageRef image_;
  Image<std::uint8_t>& rows_;  ///< row y in row y % (2 kAtOnce)
  int end_ = 0;                ///< end of the converted rows
};

/// Rows of inverse depth in 1/m; 0 where there is no measurement: zero, negative, NaN, infinite, 65535 of 16 bits, or
/// from `end` metres on.
class InverseDepthRows {
 public:
  /// @param depth borrowed. @param end metres; depth from there on counts as not measured.
  InverseDepthRows(const ImageRef& depth, double end, const kernel::Kernels& kernels = portable_kernels())
      : depth_(depth), kernels_(kernels), words_(depth.format == PixelFormat::DepthU16) {
    const double units_per_metre = words_ ? depth.depth_units_per_metre : 1, values_end = end * units_per_metre;
    units_ = {static_cast<float>(units_per_metre), static_cast<float>(1e-3 * units_per_metre),
              static_cast<float>(words_ ? std::min(values_end, 65535.0) : values_end)};
  }

  int width() const { return depth_.width; }    ///< pixels
  int height() const { return depth_.height; }  ///< pixels

  /// Writes row y to `out`, which has room for it: 1/m, 0 = not measured.
  void operator()(int y, float* out) const {
    const void* row = static_cast<const unsigned char*>(depth_.data) + y * depth_.stride;
    if (words_)
      kernels_.invert_words(static_cast<const std::uint16_t*>(row), depth_.width, units_, out);
    else
      kernels_.invert_floats(static_cast<const float*>(row), depth_.width, units_, out);
  }

 private:
  ImageRef depth_;
  const kernel::Kernels& kernels_;
  bool words_;
  kernel::DepthUnits units_;
};

/// The same rows with the bias subtracted. Depths that this would move beyond `max_depth` metres are set to
/// `max_depth`.
class UnbiasedDepthRows {
 public:
  /// @param rows scratch. All else is borrowed.
  UnbiasedDepthRows(const InverseDepthRows& measured, double max_depth, const DepthBias& bias, Image<float>& rows,
                    const kernel::Kernels& kernels = portable_kernels())
      : measured_(measured), kernels_(kernels), rows_(rows), height_(measured.height()) {
    const int width = measured.width();
    rows.resize(width, 3);
    row_ = {rows.row(1), rows.row(2), 0, static_cast<float>(1 / max_depth)};
    for (int u = 0; u < width; ++u) {
      const double s = 2.0 * u / width - 1, middle = bias(s, 0);
      rows(u, 1) = static_cast<float>(middle);
      rows(u, 2) = static_cast<float>(bias(s, 1) - middle);
    }
  }

  /// Writes row y to `out`, which has room for it: 1/m, 0 = not measured.
  void operator()(int y, float* out) {
    measured_(y, rows_.row(0));
    row_.t = 2 * static_cast<float>(y) / static_cast<float>(height_) - 1;
    kernels_.take_bias(rows_.row(0), rows_.width(), row_, out);
  }

 private:
  InverseDepthRows measured_;
  const kernel::Kernels& kernels_;
  Image<float>& rows_;  ///< the measured row; the bias at t = 0, and its derivative by t
  int height_;
  kernel::RowBias row_;
};

DOT_END_NAMESPACE
