// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "dot/image/pyramid.hpp"

DOT_BEGIN_NAMESPACE

/// A level of a pyramid with the 2x2 pixels from each pixel on side by side, so that a single load gives a bilinear
/// sample. It is worth the copy where many places are compared on a small level.
struct Quads {
  Image<std::array<std::uint8_t, 4>> pixels;  ///< (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)
  int level = -1;                             ///< of the pyramid

  /// Copies a level. Beyond the border, the pixels at the border are repeated. @pre The pyramid has that level.
  void copy_level(const Pyramid& image, int from) {
    const Image<std::uint8_t>& grey = image.levels[static_cast<std::size_t>(from)];
    const int width = grey.width(), height = grey.height();
    pixels.resize(width, height);
    level = from;
    for (int y = 0; y < height; ++y) {
      const std::uint8_t *upper = grey.row(y), *lower = grey.row(std::min(y + 1, height - 1));
      std::array<std::uint8_t, 4>* out = pixels.row(y);
      for (int x = 0; x + 1 < width; ++x) out[x] = {upper[x], upper[x + 1], lower[x], lower[x + 1]};
      out[width - 1] = {upper[width - 1], upper[width - 1], lower[width - 1], lower[width - 1]};
    }
  }
};

DOT_END_NAMESPACE
