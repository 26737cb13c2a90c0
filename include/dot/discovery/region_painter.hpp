// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// Makes the mask of a region of cells. Small holes are closed, and the border follows the depth of the pixels.
/// @param region cells as y * q.width() + x, of pixels of size `cell`. @param q of the cells.
class RegionPainter {
 public:
  /// @param pixels inverse depth of the pixels, 1/m. @param sigma its standard deviation at an inverse depth. @param
  /// out the mask, in pixels.
  template <typename Sigma>
  void operator()(const std::vector<int>& region, const Image<float>& q, const Image<float>& pixels, int cell,
                  Sigma&& sigma, Mask& out) {
    constexpr int margin = 3;
    int x0 = q.width(), y0 = q.height(), x1 = 0, y1 = 0;
    for (const int i : region) {
      x0 = std::min(x0, i % q.width()), x1 = std::max(x1, i % q.width());
      y0 = std::min(y0, i / q.width()), y1 = std::max(y1, i / q.width());
    }
    x0 -= margin, y0 -= margin;
    const int w = x1 - x0 + 1 + margin, h = y1 - y0 + 1 + margin;
    inside_.resize(w, h);
    inside_.fill(0);
    near_.resize(w, h);
    near_.fill(0);
    far_.resize(w, h);
    far_.fill(1e9f);
    for (const int i : region) {
      const int x = i % q.width() - x0, y = i / q.width() - y0;
      const float value = q.row(0)[i], slack = std::max(0.06f * value, 3 * static_cast<float>(sigma(value)));
      inside_(x, y) = 255;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u) {
          near_(u, v) = std::max(near_(u, v), value + slack);
          far_(u, v) = std::min(far_(u, v), value - slack);
        }
    }
    const ImageView<const std::uint8_t> inside = std::as_const(inside_).view();
    dilate<2>(inside, rows_, inside_.view());
    erode<2>(inside, rows_, inside_.view());
    fill_holes();
    inner_.resize(w, h);
    erode<1>(inside, rows_, inner_.view());
    const std::array<int, 4> box =
        clip_box({x0 * cell, y0 * cell, w * cell, h * cell}, pixels.width(), pixels.height());
    paint(box, pixels, cell, x0, y0);
    const auto painted = [this, &box](int v) {
      return [row = painted_.row(v - box[1]), left = box[0]](int u) { return row[u - left] != 0; };
    };
    fill_mask_by_rows(box, painted, out);
  }

 private:
  /// Adds all that the region encloses, such as a window through which the background is visible.
  void fill_holes() {
    constexpr std::uint8_t outside = 1;
    const auto reach = [this](int x, int y) {
      if (!inside_.contains(x, y) || inside_(x, y) != 0) return;
      inside_(x, y) = outside;
      front_.push_back({x, y});
    };
    front_.clear();
    reach(0, 0);  // in the margin
    while (!front_.empty()) {
      const auto [x, y] = front_.back();
      front_.pop_back();
      reach(x - 1, y), reach(x + 1, y), reach(x, y - 1), reach(x, y + 1);
    }
    for (int y = 0; y < inside_.height(); ++y)
      for (int x = 0; x < inside_.width(); ++x) inside_(x, y) = inside_(x, y) == outside ? 0 : 255;
  }

  /// Paints the pixels of `box`, which begins with cell (x0, y0) or at the border of the image: those within the bounds
  /// of their cell, and inside the region those without depth or bounds.
  void paint(const std::array<int, 4>& box, const Image<float>& pixels, int cell, int x0, int y0) {
    const auto [left, top, width, height] = box;
    painted_.resize(width, height);
    painted_.fill(0);
    for (int v = top; v < top + height; ++v) {
      const int y = v / cell - y0;
      const float* values = pixels.row(v);
      std::uint8_t* out = painted_.row(v - top);
      for (int x = left / cell - x0; x < inside_.width() && (x0 + x) * cell < left + width; ++x) {
        const bool inner = inner_(x, y) != 0, bounded = near_(x, y) > 0;
        if (!inner && !bounded) continue;
        const float low = bounded ? far_(x, y) : 0, high = bounded ? near_(x, y) : std::numeric_limits<float>::max();
        const int end = std::min((x0 + x + 1) * cell, left + width);
        for (int u = std::max((x0 + x) * cell, left); u < end; ++u) {
          const float q = values[u];
          out[u - left] = (q > 0 ? q >= low && q <= high : inner) ? 255 : 0;
        }
      }
    }
  }

  std::vector<std::array<int, 2>> front_;      ///< of the flood fill outside
  Image<std::uint8_t> inside_, inner_, rows_;  ///< cells
  Image<std::uint8_t> painted_;                ///< pixels of the box
  Image<float> near_, far_;                    ///< bounds of the inverse depth about each cell
};

DOT_END_NAMESPACE
