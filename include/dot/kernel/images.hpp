// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// What the kernels for rows of images take.

namespace dot::kernel {

/// What a depth sensor's values mean.
struct DepthUnits {
  float unit = 1;           ///< values a metre
  float near = 0, far = 0;  ///< values; beyond them is no measurement, nor is NaN
};

/// What is wrong with the inverse depths of a row, 1/m: base + slope * t, one of each for a pixel.
struct RowBias {
  const float* base = nullptr;
  const float* slope = nullptr;
  float t = 0;
  float least = 0;  ///< 1/m: what is less without the bias is that
};

/// Weights of a symmetric filter of five pixels, in 1/256: `middle + 2 (next + outer) = 256`.
struct BlurWeights {
  unsigned short middle = 256, next = 0, outer = 0;
};

/// What differs more, relative to the larger inverse depth, is not one surface.
constexpr float kSameSurface = 0.1f;

}  // namespace dot::kernel
