// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// @file
/// Input of the kernel that searches for strong gradients; see points/select.hpp.

namespace dot::kernel {

/// Some rows of an image, with a mask of the pixels that count.
struct GradientStrip {
  const unsigned char* grey = nullptr;  ///< the strip's first pixel; a border of one pixel is read, too
  std::ptrdiff_t grey_stride = 0;       ///< bytes
  const unsigned char* mask = nullptr;  ///< non-zero = counts
  std::ptrdiff_t mask_stride = 0;       ///< bytes
  const float* q = nullptr;             ///< a pixel counts only if its value is above 0; null: all count
  std::ptrdiff_t q_stride = 0;          ///< bytes
  int width = 0, rows = 0;              ///< pixels; at most kMaxStripRows
  int row_step = 1;                     ///< rows of the image from one row of the strip to the next

  /// Key of a pixel in a row of the strip. A stronger gradient has a larger key, and among equals the upper pixel.
  /// @param gradient (2 |grad I|)^2, from central differences without the factor 1/2.
  constexpr int key(int gradient, int row) const { return (gradient << row_bits()) + (rows - 1 - row); }
  constexpr int gradient_of(int key) const { return key >> row_bits(); }
  constexpr int row_of(int key) const { return rows - 1 - (key & ((1 << row_bits()) - 1)); }
  constexpr int row_bits() const {
    int bits = 0;
    while ((1 << bits) < rows) ++bits;
    return bits;
  }
};
inline constexpr int kMaxStripRows = 16384;  ///< a key must fit into an int

}  // namespace dot::kernel
