// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "dot/image/image.hpp"

namespace dot {

/// Builds the levels of a pyramid, each half the size of the one before, in one pass over the image. A row of a level
/// is computed as soon as both rows of the level beneath are complete, while they are in the cache.
/// @param bottom bottom(y, out): row y of level 0, from the top.
/// @param halve halve(upper, lower, n, out): n pixels of a row from 2 n of each of two.
template <typename T, typename Bottom, typename Halve>
void build_levels(int width, int height, int count, Bottom&& bottom, Halve&& halve, std::vector<Image<T>>& levels) {
  levels.resize(static_cast<std::size_t>(count));
  for (std::size_t l = 0; l < levels.size(); ++l) levels[l].resize(width >> l, height >> l);
  for (int y = 0; y < height; ++y) {
    bottom(y, levels[0].row(y));
    int done = y + 1;  // rows of the level beneath
    for (std::size_t l = 1; l < levels.size() && done % 2 == 0; ++l, done /= 2) {
      const Image<T>& below = levels[l - 1];
      halve(below.row(done - 2), below.row(done - 1), levels[l].width(), levels[l].row(done / 2 - 1));
    }
  }
}

}  // namespace dot
