// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/kernels.hpp"

DOT_BEGIN_NAMESPACE

/// A plane in space is linear in inverse depth over the image: q(u, v) = q + du (u - u0) + dv (v - v0).
using PlaneFit = kernel::Plane;

/// Pixels whose depths together count as one. The error of n pixels averages like that of n / kCorrelatedArea
/// independent ones, because stereo and interpolated depth are smooth.
inline constexpr int kCorrelatedArea = 45;

/// Windows for planes about single pixels. Depths of neighbouring pixels are not independent, so some rows of a large
/// window give as much information as all.
/// @param radius pixels. @param min_inliers pixels that must support a plane.
inline kernel::PlaneWindow plane_window(int radius, int min_inliers) {
  return {radius, radius < 7 ? 1 : radius < 16 ? 2 : radius / 8, min_inliers};
}

/// The view in the form that the kernels take.
inline kernel::InverseDepth kernel_view(ImageView<const float> inverse_depth) {
  return {inverse_depth.data, inverse_depth.width, inverse_depth.height, inverse_depth.stride};
}

/// The depths of one surface: those of a mask, within a range.
/// @param inverse_depth of the mask's rectangle. @param mask non-zero = pixel of the surface.
/// @param surface gets its inverse depth, 0 elsewhere.
inline void cut_surface(ImageView<const float> inverse_depth, ImageView<const std::uint8_t> mask, float q_min,
                        float q_max, Image<float>& surface) {
  surface.resize(mask.width, mask.height);
  const float least = std::max(q_min, std::numeric_limits<float>::min());
  for (int y = 0; y < mask.height; ++y) {
    const float* q = inverse_depth.row(y);
    const std::uint8_t* may = mask.row(y);
    float* __restrict out = surface.row(y);
    for (int x = 0; x < mask.width; ++x) {
      const float v = q[x];
      out[x] = ((may[x] != 0) & (v >= least) & (v <= q_max)) ? v : 0.0f;  // without branches, for SIMD code
    }
  }
}

DOT_END_NAMESPACE
