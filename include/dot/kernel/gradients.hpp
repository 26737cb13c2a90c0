// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// @file
/// What the kernel that looks for strong gradients takes; see points/select.hpp.

namespace dot::kernel {

/// Some rows of an image, and which of their pixels count.
struct GradientStrip {
  const unsigned char* grey = nullptr;  ///< the strip's first pixel; one pixel all around the strip is read too
  std::ptrdiff_t grey_stride = 0;       ///< bytes
  const unsigned char* mask = nullptr;  ///< non-zero = counts
  std::ptrdiff_t mask_stride = 0;       ///< bytes
  const float* q = nullptr;             ///< where not above 0, the pixel does not count; null: all do
  std::ptrdiff_t q_stride = 0;          ///< bytes
  int width = 0, rows = 0;              ///< pixels; at most kMaxStripRows

  /// Of a pixel in a row of the strip: the larger, the stronger its gradient, and among equals the higher up.
  /// @param gradient (2 |grad I|)^2, from central differences without their half.
  constexpr int key(int gradient, int row) const { return (gradient << row_bits()) + (rows - 1 - row); }
  constexpr int gradient_of(int key) const { return key >> row_bits(); }
  constexpr int row_of(int key) const { return rows - 1 - (key & ((1 << row_bits()) - 1)); }
  constexpr int row_bits() const {
    int bits = 0;
    while ((1 << bits) < rows) ++bits;
    return bits;
  }
};
constexpr int kMaxStripRows = 16384;  ///< a key must fit into an int

}  // namespace dot::kernel
