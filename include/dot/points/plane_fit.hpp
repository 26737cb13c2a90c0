// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

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

/// Fits a plane robustly to the inverse depth in a window: three least-squares passes, the first with a wide gate about
/// the window's centre (a steep plane), then `gate` about the fit.
/// @param accept (x, y) -> bool: which pixels belong to the surface's region.
/// @param start inverse depth near which the surface is searched.
/// @param min_inliers pixels that must support it.
/// @return false when too few do or the fit is degenerate.
template <typename Accept>
bool fit_plane(ImageView<const float> inverse_depth, int u0, int v0, int radius, float start, float gate,
               int min_inliers, Accept&& accept, PlaneFit& fit) {
  const int x0 = std::max(u0 - radius, 0), x1 = std::min(u0 + radius, inverse_depth.width - 1);
  const int y0 = std::max(v0 - radius, 0), y1 = std::min(v0 + radius, inverse_depth.height - 1);
  fit = {start, 0, 0, 0, 0};
  float width = 3 * gate;
  for (int pass = 0; pass < 3; ++pass, width = gate) {
    // Normal equations of [q, du, dv] about (u0, v0) and the current value, in double for the cancellation.
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, sr = 0, sxr = 0, syr = 0, srr = 0;
    for (int y = y0; y <= y1; ++y) {
      const float* row = inverse_depth.row(y);
      for (int x = x0; x <= x1; ++x) {
        if (row[x] <= 0 || !accept(x, y)) continue;
        const float dx = static_cast<float>(x - u0), dy = static_cast<float>(y - v0);
        const float r = row[x] - (fit.q + fit.du * dx + fit.dv * dy);
        if (std::abs(r) > width) continue;
        n += 1, sx += dx, sy += dy, sxx += dx * dx, sxy += dx * dy, syy += dy * dy;
        sr += r, sxr += dx * r, syr += dy * r, srr += r * r;
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
