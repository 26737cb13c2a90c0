// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/levels.hpp"
#include "dot/kernel/portable_kernels.hpp"

DOT_BEGIN_NAMESPACE

/// Grey images, each half the size of the one before. Level 0 is the image after a Gaussian blur that reduces pixel
/// noise and aliasing in the gradients. A pixel of level l + 1 is the mean of 2x2 pixels of level l, so u_l = (u_0 +
/// 0.5) / 2^l - 0.5.
struct Pyramid {
  std::vector<Image<std::uint8_t>> levels;  ///< level 0 has full size

  /// Columns of level 0.
  int width() const { return levels.empty() ? 0 : levels[0].width(); }
  /// Rows of level 0.
  int height() const { return levels.empty() ? 0 : levels[0].height(); }
  /// Number of levels.
  int size() const { return static_cast<int>(levels.size()); }

  /// @param grey_row grey_row(y): row y of the image. All rows are requested in order; after a row, up to four rows
  /// above it are requested again.
  /// @param blur_sigma pixels of level 0.
  template <typename GreyRow>
  void build(int width, int height, GreyRow&& grey_row, int level_count, const kernel::Kernels& kernels,
             double blur_sigma = 0.8) {
    const kernel::BlurWeights weights = blur_weights(blur_sigma);
    const auto blurred_row = [&](int y, std::uint8_t* out) {
      const std::uint8_t* rows[5];
      for (int i = 0; i < 5; ++i) rows[i] = grey_row(std::clamp(y + i - 2, 0, height - 1));
      kernels.blur(rows, width, weights, out);
    };
    build_levels(width, height, level_count, blurred_row, kernels.halve, levels);
  }
  /// The same from a grey image.
  void build(ImageView<const std::uint8_t> grey, int level_count, const kernel::Kernels& kernels = portable_kernels(),
             double blur_sigma = 0.8) {
    build(
        grey.width, grey.height, [&](int y) { return grey.row(y); }, level_count, kernels, blur_sigma);
  }

  /// Weights of a Gaussian. The outer weights are rounded, and the middle one gets the rest.
  static kernel::BlurWeights blur_weights(double sigma) {
    const double next = std::exp(-0.5 / (sigma * sigma)), outer = std::exp(-2 / (sigma * sigma));
    const double unit = 256 / (1 + 2 * (next + outer));
    kernel::BlurWeights w;
    w.outer = static_cast<unsigned short>(std::lround(unit * outer));
    w.next = static_cast<unsigned short>(std::lround(unit * (next + outer) - w.outer));
    w.middle = static_cast<unsigned short>(256 - 2 * (w.next + w.outer));
    return w;
  }
};

/// The number of levels for which the coarsest is about 80 pixels wide and at least 20 high, at most `max_levels`.
inline int pyramid_levels(int width, int height, int max_levels) {
  int levels = 1;
  while (levels < max_levels && (width >> levels) >= 70 && (height >> levels) >= 20) ++levels;
  return levels;
}

/// Value of an 8-bit image at (u, v), bilinear. @pre 0 <= u < width - 1 and 0 <= v < height - 1.
inline float bilinear(const Image<std::uint8_t>& image, float u, float v) {
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const float a = u - static_cast<float>(x), b = v - static_cast<float>(y);
  const std::uint8_t *p0 = image.row(y) + x, *p1 = image.row(y + 1) + x;
  return (1 - b) * ((1 - a) * static_cast<float>(p0[0]) + a * static_cast<float>(p0[1])) +
         b * ((1 - a) * static_cast<float>(p1[0]) + a * static_cast<float>(p1[1]));
}

/// Value and gradient of an 8-bit image at (u, v), bilinear between the pixels' values and central differences.
struct Sample {
  float value;  ///< grey values
  float gx;     ///< grey values per pixel, to the right
  float gy;     ///< grey values per pixel, downwards
};

/// @pre 1 <= u < width - 2 and 1 <= v < height - 2.
inline Sample sample(const Image<std::uint8_t>& image, float u, float v) {
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const float a = u - static_cast<float>(x), b = v - static_cast<float>(y);
  const std::ptrdiff_t stride = image.width();
  const std::uint8_t* p = image.row(y) + x;
  const auto f = [&](int i, int j) { return static_cast<float>(p[i + j * stride]); };
  const float w00 = (1 - a) * (1 - b), w10 = a * (1 - b), w01 = (1 - a) * b, w11 = a * b;
  const float i00 = f(0, 0), i10 = f(1, 0), i01 = f(0, 1), i11 = f(1, 1);
  return {w00 * i00 + w10 * i10 + w01 * i01 + w11 * i11,
          0.5f * (w00 * (i10 - f(-1, 0)) + w10 * (f(2, 0) - i00) + w01 * (i11 - f(-1, 1)) + w11 * (f(2, 1) - i01)),
          0.5f * (w00 * (i01 - f(0, -1)) + w10 * (i11 - f(1, -1)) + w01 * (f(0, 2) - i00) + w11 * (f(1, 2) - i10))};
}

DOT_END_NAMESPACE
