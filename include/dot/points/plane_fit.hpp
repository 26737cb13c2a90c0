// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/view.hpp"
#include "dot/kernel/lanes.hpp"

DOT_BEGIN_NAMESPACE

/// A plane in space is linear in inverse depth over the image: q(u, v) = q + du (u - u0) + dv (v - v0).
struct PlaneFit {
  float q = 0;           ///< 1/m at (u0, v0)
  float du = 0, dv = 0;  ///< 1/m per pixel
  float rms = 0;         ///< of the inliers, 1/m
  int inliers = 0;
};

/// Whose depth may be used: the pixels of a mask, within a range of inverse depth.
struct DepthSupport {
  ImageView<const std::uint8_t> mask;  ///< non-zero = may; empty: all pixels of the image may
  int x = 0, y = 0;                    ///< pixels: its top left corner in the image
  float q_min = 0;                     ///< 1/m; nothing at or below 0 is a measurement
  float q_max = std::numeric_limits<float>::max();
};

namespace plane_fitting {

/// A window of the image and the plane about which its residuals are taken: first + du x + dv y, (x, y) from its top
/// left pixel.
struct Window {
  int x0, y0, x1, y1;  ///< pixels, ends excluded
  int row_step;
  float first, du, dv;
  float gate;  ///< residuals beyond are left out
};

/// Sums over the pixels of a window within the gate, for the normal equations of [q, du, dv]; (x, y) as in Window.
struct Sums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, r = 0, xr = 0, yr = 0, rr = 0;
};

/// Kept by column while the rows pass, some columns at a time.
template <typename Lanes>
Sums sum_window(ImageView<const float> inverse_depth, const Window& window, const DepthSupport& support) {
  constexpr int W = Lanes::W;
  using F = typename Lanes::F;
  using M = typename Lanes::M;
  constexpr float index[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  static_assert(W <= 16, "index has one number for each lane");
  const float least = std::max(support.q_min, std::numeric_limits<float>::min());
  const F q_min = Lanes::set(least), q_max = Lanes::set(support.q_max), gate = Lanes::set(window.gate);
  const F one = Lanes::set(1), slope = Lanes::set(window.du);
  const ImageView<const std::uint8_t>& mask = support.mask;
  Sums out;
  for (int x = window.x0; x < window.x1; x += W) {
    const int columns = std::min(W, window.x1 - x);
    const M inside = Lanes::less(Lanes::load(index), Lanes::set(static_cast<float>(columns)));
    const bool depth_ends = x + W > inverse_depth.width, mask_ends = x + W > support.x + mask.width;
    float last_depths[W] = {};
    unsigned char last_mask[W] = {};
    F n = Lanes::set(0), y = n, yy = n, r = n, yr = n, rr = n;
    for (int v = window.y0; v < window.y1; v += window.row_step) {
      const float* row = inverse_depth.row(v) + x;
      if (depth_ends) std::copy_n(row, columns, last_depths), row = last_depths;
      const F q = Lanes::load(row);
      M may = Lanes::both(inside, Lanes::both(Lanes::not_less(q, q_min), Lanes::not_less(q_max, q)));
      if (mask.data) {
        const unsigned char* bytes = mask.row(v - support.y) + (x - support.x);
        if (mask_ends) std::copy_n(bytes, columns, last_mask), bytes = last_mask;
        may = Lanes::without(may, Lanes::zero_bytes(bytes));
      }
      const float dy = static_cast<float>(v - window.y0);
      const float begin = window.first + window.du * static_cast<float>(x - window.x0) + window.dv * dy;
      const F residual = Lanes::sub(q, Lanes::fma(slope, Lanes::load(index), Lanes::set(begin)));
      may = Lanes::both(may, Lanes::not_less(gate, Lanes::abs(residual)));
      const F w = Lanes::keep(may, one), wr = Lanes::keep(may, residual), row_y = Lanes::set(dy);
      n = Lanes::add(n, w);
      y = Lanes::fma(w, row_y, y);
      yy = Lanes::fma(Lanes::mul(w, row_y), row_y, yy);
      r = Lanes::add(r, wr);
      yr = Lanes::fma(wr, row_y, yr);
      rr = Lanes::fma(wr, wr, rr);
    }
    float columns_of[6][W];
    int k = 0;
    for (const F& sum : {n, y, yy, r, yr, rr}) Lanes::store(columns_of[k++], sum);
    for (int i = 0; i < columns; ++i) {
      const double dx = x + i - window.x0;
      const auto at = [&](int row) { return static_cast<double>(columns_of[row][i]); };
      out.n += at(0), out.x += dx * at(0), out.xx += dx * dx * at(0);
      out.y += at(1), out.xy += dx * at(1), out.yy += at(2);
      out.r += at(3), out.xr += dx * at(3), out.yr += at(4), out.rr += at(5);
    }
  }
  return out;
}

/// Depths of neighbouring pixels are not independent: of a large window some rows tell as much as all.
inline int row_step(int radius) { return radius < 7 ? 1 : radius < 16 ? 2 : radius / 8; }

}  // namespace plane_fitting

/// Fits a plane robustly to the inverse depth in a window: three least-squares passes, the first with a wide gate about
/// the window's centre (a steep plane), then `gate` about the fit.
/// @param start inverse depth near which the surface is searched.
/// @param min_inliers pixels that must support it. Of larger windows not all rows are read; they count for the others.
/// @return false when too few do or the fit is degenerate.
inline bool fit_plane(ImageView<const float> inverse_depth, int u0, int v0, int radius, float start, float gate,
                      int min_inliers, const DepthSupport& support, PlaneFit& fit) {
  const bool masked = support.mask.data != nullptr;
  const int left = masked ? std::max(support.x, 0) : 0, top = masked ? std::max(support.y, 0) : 0;
  const int right = masked ? std::min(support.x + support.mask.width, inverse_depth.width) : inverse_depth.width;
  const int bottom = masked ? std::min(support.y + support.mask.height, inverse_depth.height) : inverse_depth.height;
  plane_fitting::Window window{};
  window.x0 = std::max(u0 - radius, left), window.x1 = std::min(u0 + radius + 1, right);
  window.y0 = std::max(v0 - radius, top), window.y1 = std::min(v0 + radius + 1, bottom);
  window.row_step = plane_fitting::row_step(radius);
  fit = {start, 0, 0, 0, 0};
  if (window.x1 <= window.x0 || window.y1 <= window.y0) return false;
  const int height = window.y1 - window.y0;
  const double rows_for_one = 1.0 * height / ((height + window.row_step - 1) / window.row_step);
  const float to_x = static_cast<float>(window.x0 - u0), to_y = static_cast<float>(window.y0 - v0);
  double before = 0;
  window.gate = 3 * gate;
  for (int pass = 0; pass < 3; ++pass, window.gate = gate) {
    window.first = fit.q + fit.du * to_x + fit.dv * to_y, window.du = fit.du, window.dv = fit.dv;
    const plane_fitting::Sums s = plane_fitting::sum_window<PortableLanes>(inverse_depth, window, support);
    if (s.n * rows_for_one < min_inliers) return false;
    const double cxx = s.xx - s.x * s.x / s.n, cxy = s.xy - s.x * s.y / s.n, cyy = s.yy - s.y * s.y / s.n;
    const double cxr = s.xr - s.x * s.r / s.n, cyr = s.yr - s.y * s.r / s.n;
    const double det = cxx * cyy - cxy * cxy;
    if (det < 1e-6 * s.n * s.n) return false;
    const double a = (cyy * cxr - cxy * cyr) / det, b = (cxx * cyr - cxy * cxr) / det;
    const double rss = s.rr - s.r * s.r / s.n - a * cxr - b * cyr;
    const double at_corner = (s.r - a * s.x - b * s.y) / s.n;
    fit.q += static_cast<float>(at_corner - a * static_cast<double>(to_x) - b * static_cast<double>(to_y));
    fit.du += static_cast<float>(a);
    fit.dv += static_cast<float>(b);
    fit.rms = static_cast<float>(std::sqrt(std::max(rss, 0.0) / s.n));
    fit.inliers = static_cast<int>(std::lround(s.n * rows_for_one));
    if (s.n == before) break;  // as many pixels as before: nothing would change
    before = s.n;
  }
  return fit.q > 0;
}

DOT_END_NAMESPACE
