// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
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
    fill_mask(
        box,
        [&](int u, int v) {
          const int x = u / cell - x0, y = v / cell - y0;
          const float value = pixels(u, v);
          if (!(value > 0)) return inner_(x, y) != 0;
          return near_(x, y) > 0 ? value >= far_(x, y) && value <= near_(x, y) : inner_(x, y) != 0;
        },
        out);
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

  std::vector<std::array<int, 2>> front_;  ///< of the flood fill outside
  Image<std::uint8_t> inside_, inner_, rows_;
  Image<float> near_, far_;  ///< bounds of the inverse depth about each cell
};

DOT_END_NAMESPACE
