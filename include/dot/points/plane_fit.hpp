// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/view.hpp"

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

/// Sums of a window for the normal equations of [q, du, dv] about its middle, kept by column while the rows pass: no
/// operation depends on its neighbour, which is what compilers need to make SIMD code of the loop.
struct ColumnSums {
  static constexpr int kWidth = 16;
  using Row = std::array<float, kWidth>;
  Row n{}, y{}, yy{}, r{}, yr{}, rr{};

  /// @param q inverse depths of a row; @param may 0 or 1 for each of them; @param first, slope of the plane there.
  void add(const float* q, const float* may, int width, float dy, float first, float slope, float gate) {
    for (int i = 0; i < width; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const float residual = q[i] - (first + slope * static_cast<float>(i));
      const float w = std::abs(residual) <= gate ? may[i] : 0.0f;
      const float wr = w * residual;
      n[k] += w;
      y[k] += w * dy;
      yy[k] += w * dy * dy;
      r[k] += wr;
      yr[k] += wr * dy;
      rr[k] += wr * residual;
    }
  }
};

}  // namespace plane_fitting

/// Fits a plane robustly to the inverse depth in a window: three least-squares passes, the first with a wide gate about
/// the window's centre (a steep plane), then `gate` about the fit.
/// @param start inverse depth near which the surface is searched.
/// @param min_inliers pixels that must support it.
/// @return false when too few do or the fit is degenerate.
inline bool fit_plane(ImageView<const float> inverse_depth, int u0, int v0, int radius, float start, float gate,
                      int min_inliers, const DepthSupport& support, PlaneFit& fit) {
  using plane_fitting::ColumnSums;
  const bool masked = support.mask.data != nullptr;
  const int left = masked ? std::max(support.x, 0) : 0, top = masked ? std::max(support.y, 0) : 0;
  const int right = masked ? std::min(support.x + support.mask.width, inverse_depth.width) : inverse_depth.width;
  const int bottom = masked ? std::min(support.y + support.mask.height, inverse_depth.height) : inverse_depth.height;
  const int x0 = std::max(u0 - radius, left), x1 = std::min(u0 + radius + 1, right);
  const int y0 = std::max(v0 - radius, top), y1 = std::min(v0 + radius + 1, bottom);
  fit = {start, 0, 0, 0, 0};
  float width = 3 * gate;
  for (int pass = 0; pass < 3; ++pass, width = gate) {
    // Normal equations about (u0, v0) and the current value, in double for the cancellation.
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, sr = 0, sxr = 0, syr = 0, srr = 0;
    for (int x = x0; x < x1; x += ColumnSums::kWidth) {
      const int columns = std::min(ColumnSums::kWidth, x1 - x);
      ColumnSums sums;
      ColumnSums::Row may;
      for (int y = y0; y < y1; ++y) {
        const float* q = inverse_depth.row(y) + x;
        for (int i = 0; i < columns; ++i)
          may[static_cast<std::size_t>(i)] =
              (q[i] > 0) & (q[i] >= support.q_min) & (q[i] <= support.q_max) ? 1.0f : 0.0f;
        if (masked) {
          const std::uint8_t* mask = support.mask.row(y - support.y) + (x - support.x);
          for (int i = 0; i < columns; ++i) may[static_cast<std::size_t>(i)] *= mask[i] ? 1.0f : 0.0f;
        }
        const float dy = static_cast<float>(y - v0);
        sums.add(q, may.data(), columns, dy, fit.q + fit.du * static_cast<float>(x - u0) + fit.dv * dy, fit.du, width);
      }
      for (int i = 0; i < columns; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double dx = x + i - u0;
        const auto at = [k](const ColumnSums::Row& row) { return static_cast<double>(row[k]); };
        n += at(sums.n), sx += dx * at(sums.n), sxx += dx * dx * at(sums.n);
        sy += at(sums.y), sxy += dx * at(sums.y), syy += at(sums.yy);
        sr += at(sums.r), sxr += dx * at(sums.r), syr += at(sums.yr), srr += at(sums.rr);
      }
    }
    if (n < min_inliers) return false;
    const double cxx = sxx - sx * sx / n, cxy = sxy - sx * sy / n, cyy = syy - sy * sy / n;
    const double cxr = sxr - sx * sr / n, cyr = syr - sy * sr / n;
    const double det = cxx * cyy - cxy * cxy;
    if (det < 1e-6 * n * n) return false;
    const double a = (cyy * cxr - cxy * cyr) / det, b = (cxx * cyr - cxy * cxr) / det;
    const double rss = srr - sr * sr / n - a * cxr - b * cyr;
    fit.q += static_cast<float>((sr - a * sx - b * sy) / n);
    fit.du += static_cast<float>(a);
    fit.dv += static_cast<float>(b);
    fit.rms = static_cast<float>(std::sqrt(std::max(rss, 0.0) / n));
    fit.inliers = static_cast<int>(n);
  }
  return fit.q > 0;
}

DOT_END_NAMESPACE
