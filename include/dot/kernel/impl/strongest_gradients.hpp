// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/gradients.hpp"

/// @file
/// Plain loops without branches, which become vector code with the flags of their unit. V is only the unit's name, see
/// impl/kernels_of.hpp.

namespace dot::kernel {

template <typename V, bool kMeasuredAlone>
void strongest_of(const GradientStrip& strip, int threshold, int* keys) {
  const int none = strip.key(threshold, 0), width = strip.width;
  for (int x = 0; x < width; ++x) keys[x] = none;
  for (int y = 0; y < strip.rows; ++y) {
    const int row_of_image = y * strip.row_step;
    const unsigned char* row = strip.grey + row_of_image * strip.grey_stride;
    const unsigned char* above = row - strip.grey_stride;
    const unsigned char* below = row + strip.grey_stride;
    const unsigned char* mask = strip.mask + row_of_image * strip.mask_stride;
    const float* q = nullptr;
    if constexpr (kMeasuredAlone)
      q = reinterpret_cast<const float*>(reinterpret_cast<const unsigned char*>(strip.q) +
                                         row_of_image * strip.q_stride);
    const int row_bits = strip.row_bits(), of_row = strip.key(0, y);
    for (int x = 0; x < width; ++x) {
      // 16-bit products are faster.
      const auto gx = static_cast<short>(row[x + 1] - row[x - 1]), gy = static_cast<short>(below[x] - above[x]);
      int key = ((gx * gx + gy * gy) << row_bits) + of_row;
      key = mask[x] ? key : 0;
      if constexpr (kMeasuredAlone) key = q[x] > 0 ? key : 0;
      keys[x] = key > keys[x] ? key : keys[x];
    }
  }
}

template <typename V>
void strongest_gradients(const GradientStrip& strip, int threshold, int* keys) {
  strip.q ? strongest_of<V, true>(strip, threshold, keys) : strongest_of<V, false>(strip, threshold, keys);
}

}  // namespace dot::kernel
