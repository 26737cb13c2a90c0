// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Input of the kernels for rows of images.

namespace dot::kernel {

/// Units and range of a depth sensor's values.
struct DepthUnits {
  float unit = 1;           ///< values per metre
  float near = 0, far = 0;  ///< values; values outside this range, and NaN, are no measurement
};

/// The bias of the inverse depths of a row, 1/m: base + slope * t, with one value of each per pixel.
struct RowBias {
  const float* base = nullptr;
  const float* slope = nullptr;
  float t = 0;
  float least = 0;  ///< 1/m: lower bound of the result
};

/// Weights of a symmetric filter of five pixels, in 1/256: `middle + 2 (next + outer) = 256`.
struct BlurWeights {
  unsigned short middle = 256, next = 0, outer = 0;
};

/// Largest difference on one surface, relative to the larger inverse depth.
inline constexpr float kSameSurface = 0.1f;

}  // namespace dot::kernel
