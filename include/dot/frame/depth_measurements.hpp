// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/view.hpp"

DOT_BEGIN_NAMESPACE

/// The measurements of a frame's sparse depth, if they are far apart, so that each is the depth of the pixels about it.
/// Of other depth it is empty.
struct DepthMeasurements {
  /// One of them.
  struct Measurement {
    int x = 0;    ///< column of its pixel
    int y = 0;    ///< row of its pixel
    float q = 0;  ///< inverse depth, 1/m
  };

  std::vector<Measurement> all;    ///< row by row
  std::vector<std::size_t> begin;  ///< of each row in `all`, and its end

  /// Whether there are any: the depth's measurements are far apart.
  bool far_apart() const { return !begin.empty(); }

  /// Forgets all, but keeps the memory.
  void clear() noexcept {
    all.clear();
    begin.clear();
  }

  /// Lists those of an image. @param sparse 1/m, <= 0 = not measured.
  void list(const Image<float>& sparse) {
    all.clear();
    begin.assign(1, 0);
    for (int y = 0; y < sparse.height(); ++y) {
      const float* row = sparse.row(y);
      for (int x = 0; x < sparse.width(); ++x)
        if (row[x] > 0) all.push_back({x, y, row[x]});
      begin.push_back(all.size());
    }
  }

  /// Counts those in a mask. @param left of the mask in the image, pixels. @param top likewise.
  /// @param mask non-zero = inside.
  int inside(int left, int top, ImageView<const std::uint8_t> mask) const {
    int count = 0;
    const int bottom = std::min(top + mask.height, static_cast<int>(begin.size()) - 1);
    for (int y = std::max(top, 0); y < bottom; ++y)
      for (std::size_t i = begin[static_cast<std::size_t>(y)]; i < begin[static_cast<std::size_t>(y) + 1]; ++i) {
        const int x = all[i].x - left;
        count += x >= 0 && x < mask.width && mask(x, y - top) != 0;
      }
    return count;
  }
};

DOT_END_NAMESPACE
