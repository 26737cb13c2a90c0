// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dot/image/view.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/template.hpp"
#include "dot/mask/warp.hpp"

DOT_BEGIN_NAMESPACE

/// Collects the part of an object that something nearer hides while a segmentation shows the rest of it.
class HiddenPart {
 public:
  /// Forgets what was collected.
  void clear() {
    pixels_.clear();
    level_ = 0;
  }

  /// Adds the pixels of an earlier outline where something nearer was measured and the segmentation does not show the
  /// object.
  /// @param moved         the outline in the segmented frame, not trimmed
  /// @param inverse_depth 1/m, of that frame, <= 0 or not finite = no measurement
  /// @param tolerance     of inverse depths, relative
  /// @param observed      the object's mask in that frame
  /// @param level         of the image pyramid, of `moved` and `inverse_depth`
  void add(const WarpedMask& moved, ImageView<const float> inverse_depth, double tolerance, const Mask& observed,
           int level = 0) {
    const Mask& mask = moved.mask;
    const auto nearer = static_cast<float>(1 + tolerance);
    const int middle = (1 << level) / 2;
    for (int v = 0; v < mask.height(); ++v) {
      const float* measured = inverse_depth.row(mask.y + v) + mask.x;
      for (int u = 0; u < mask.width(); ++u) {
        const float q = moved.inverse_depth(u, v);
        if (mask.pixels(u, v) && std::isfinite(measured[u]) && measured[u] > q * nearer &&
            !observed.at(((mask.x + u) << level) + middle, ((mask.y + v) << level) + middle)) {
          pixels_.push_back({mask.x + u, mask.y + v, level, q});
          level_ = std::max(level_, level);
        }
      }
    }
  }

  /// Makes an outline of the segmented frame from the pixels, on the coarsest of their levels. It is empty if nothing
  /// is hidden.
  void make_template(MaskTemplate& out) {
    out.clear();
    if (pixels_.empty()) return;
    out.level = level_;
    for (Pixel& p : pixels_) p = {p.x >> (level_ - p.level), p.y >> (level_ - p.level), level_, p.q};
    int left = pixels_.front().x, right = left, top = pixels_.front().y, bottom = top;
    for (const Pixel& p : pixels_) {
      left = std::min(left, p.x), right = std::max(right, p.x);
      top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    out.mask.x = left;
    out.mask.y = top;
    out.mask.pixels.resize(right - left + 1, bottom - top + 1);
    out.mask.pixels.fill(0);
    out.inverse_depth.resize(right - left + 1, bottom - top + 1);
    out.inverse_depth.fill(0);
    for (const Pixel& p : pixels_) {
      std::uint8_t& set = out.mask.pixels(p.x - left, p.y - top);
      out.mask.area += set == 0;
      set = 255;
      out.inverse_depth(p.x - left, p.y - top) = p.q;
    }
    out.measured = true;
  }

 private:
  struct Pixel {
    int x, y, level;
    float q;  ///< 1/m, expected
  };
  std::vector<Pixel> pixels_;
  int level_ = 0;  ///< the coarsest of the pixels
};

DOT_END_NAMESPACE
