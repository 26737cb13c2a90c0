// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/planes.hpp"

/// @file
/// Fits planes about V::W points at once, with a point in each lane, see impl/kernels_of.hpp.

namespace dot::kernel {

/// A window's pixels are gathered once and stay in the first-level cache for all passes. Larger windows are gathered in
/// chunks, again in each pass. Sums of a chunk are float, those of a window double.
template <typename V>
class PlaneFitter {
 public:
  PlaneFitter(const InverseDepth& image, const PlaneWindow& window) : image_(image), window_(window) {
    const int size = 2 * window.radius + 1;
    columns_ = size < image.width ? size : image.width;
    const int height = size < image.height ? size : image.height;
    rows_ = (height + window.row_step - 1) / window.row_step;
    chunk_columns_ = columns_ < kStaged ? columns_ : kStaged;
    chunk_rows_ = kStaged / chunk_columns_;
  }

  /// The planes about `count` seeds, at most W.
  void operator()(const PlaneSeed* seeds, int count, Plane* planes) {
    set_windows(seeds, count);
    for (int pass = 0; pass < 3; ++pass) {
      if (pass == 1)
        for (int lane = 0; lane < W; ++lane) gate_[lane] = seeds[lane < count ? lane : count - 1].gate;
      for (auto& sum : sums_)
        for (double& s : sum) s = 0;
      const bool fits = chunk_columns_ >= columns_ && chunk_rows_ >= rows_;
      for (int row = 0; row < rows_; row += chunk_rows_)
        for (int column = 0; column < columns_; column += chunk_columns_) {
          const int rows = rows_ - row < chunk_rows_ ? rows_ - row : chunk_rows_;
          const int columns = columns_ - column < chunk_columns_ ? columns_ - column : chunk_columns_;
          if (pass == 0 || !fits) stage(row, rows, column, columns);
          add(row, rows, column, columns);
        }
      int open = 0;
      for (int lane = 0; lane < W; ++lane) {
        if (!done_[lane]) solve(lane);
        open += !done_[lane];
      }
      if (!open) break;
    }
    for (int lane = 0; lane < count; ++lane) {
      planes[lane] = planes_[lane];
      if (!(planes[lane].q > 0)) planes[lane].inliers = 0;
    }
  }

 private:
  using F = typename V::F;
  using I = typename V::I;
  using M = typename V::M;
  static constexpr int W = V::W;
  static constexpr int kStaged = 176;  // pixels: a window of 13 x 13
  enum { kN, kX, kY, kXX, kXY, kYY, kR, kXR, kYR, kRR, kSums };

  /// Sets the windows of the seeds, ends included. Lanes without a seed get the window of the last seed.
  void set_windows(const PlaneSeed* seeds, int count) {
    for (int lane = 0; lane < W; ++lane) {
      const PlaneSeed& seed = seeds[lane < count ? lane : count - 1];
      const int r = window_.radius;
      int x0 = seed.u - r > 0 ? seed.u - r : 0, y0 = seed.v - r > 0 ? seed.v - r : 0;
      int x1 = seed.u + r < image_.width ? seed.u + r : image_.width - 1;
      int y1 = seed.v + r < image_.height ? seed.v + r : image_.height - 1;
      done_[lane] = x1 < x0 || y1 < y0;  // outside the image
      if (done_[lane]) x0 = y0 = x1 = y1 = 0;
      left_[lane] = static_cast<float>(x0), top_[lane] = static_cast<float>(y0);
      last_column_[lane] = static_cast<float>(x1 - x0), last_row_[lane] = static_cast<float>(y1 - y0);
      to_x_[lane] = x0 - seed.u, to_y_[lane] = y0 - seed.v;
      const int height = y1 - y0 + 1, taken = (height + window_.row_step - 1) / window_.row_step;
      rows_for_one_[lane] = 1.0 * height / taken;
      before_[lane] = 0;
      planes_[lane] = {};
      first_[lane] = seed.q, du_[lane] = dv_[lane] = 0;
      planes_[lane].q = seed.q;
      gate_[lane] = 3 * seed.gate;
    }
  }

  /// Gathers pixels. A pixel without measurement, or outside the window of its lane, gets a value beyond every gate.
  void stage(int first_row, int rows, int first_column, int columns) {
    const F zero = V::set(0), nowhere = V::set(1e30f);
    const M all = V::less(zero, nowhere);
    const F last_column = V::load(last_column_), last_row = V::load(last_row_);
    const I left = V::to_int(V::load(left_)), top = V::to_int(V::load(top_));
    const I column_end = V::to_int(last_column), row_end = V::to_int(last_row), four = V::seti(4);
    const I stride = V::seti(static_cast<int>(image_.stride));
    float(*out)[W] = staged_;
    for (int k = 0; k < rows; ++k) {
      const int y = (first_row + k) * window_.row_step;
      const M row_inside = V::not_less(last_row, V::set(static_cast<float>(y)));
      const I row = V::addi(top, V::mini(V::seti(y), row_end));
      const I row_at = V::addi(V::muli(row, stride), V::muli(left, four));
      for (int x = first_column; x < first_column + columns; ++x, ++out) {
        const M inside = V::both(row_inside, V::not_less(last_column, V::set(static_cast<float>(x))));
        const F q = V::gather(image_.data, V::addi(row_at, V::muli(V::mini(V::seti(x), column_end), four)));
        const M may = V::both(inside, V::less(zero, q));
        V::store(*out, V::add(V::keep(may, q), V::keep(V::without(all, may), nowhere)));
      }
    }
  }

  /// Adds the sums over the staged pixels for the normal equations of [q, du, dv], (x, y) from the window's corner.
  void add(int first_row, int rows, int first_column, int columns) {
    const F one = V::set(1), gate = V::load(gate_), first = V::load(first_), du = V::load(du_), dv = V::load(dv_);
    F n_all = V::set(0), x_all = n_all, y_all = n_all, xx_all = n_all, xy_all = n_all, yy_all = n_all;
    F r_all = n_all, xr_all = n_all, yr_all = n_all, rr_all = n_all;
    const float(*in)[W] = staged_;
    for (int k = 0; k < rows; ++k) {
      const F y = V::set(static_cast<float>((first_row + k) * window_.row_step));
      const F begin = V::fma(dv, y, first);
      F x = V::set(static_cast<float>(first_column));
      F n = V::set(0), nx = n, nxx = n, r = n, xr = n, rr = n;
      for (int c = 0; c < columns; ++c, ++in) {
        const F residual = V::sub(V::load(*in), V::fma(du, x, begin));
        const M may = V::not_less(gate, V::abs(residual));
        const F wx = V::keep(may, x), wr = V::keep(may, residual);
        n = V::add(n, V::keep(may, one));
        nx = V::add(nx, wx);
        nxx = V::fma(wx, x, nxx);
        r = V::add(r, wr);
        xr = V::fma(wr, x, xr);
        rr = V::fma(wr, wr, rr);
        x = V::add(x, one);
      }
      n_all = V::add(n_all, n), x_all = V::add(x_all, nx), xx_all = V::add(xx_all, nxx);
      r_all = V::add(r_all, r), xr_all = V::add(xr_all, xr), rr_all = V::add(rr_all, rr);
      y_all = V::fma(n, y, y_all), xy_all = V::fma(nx, y, xy_all), yy_all = V::fma(V::mul(n, y), y, yy_all);
      yr_all = V::fma(r, y, yr_all);
    }
    float sums[kSums][W];
    V::store(sums[kN], n_all), V::store(sums[kX], x_all), V::store(sums[kY], y_all), V::store(sums[kXX], xx_all);
    V::store(sums[kXY], xy_all), V::store(sums[kYY], yy_all), V::store(sums[kR], r_all), V::store(sums[kXR], xr_all);
    V::store(sums[kYR], yr_all), V::store(sums[kRR], rr_all);
    for (int s = 0; s < kSums; ++s)
      for (int lane = 0; lane < W; ++lane) sums_[s][lane] += static_cast<double>(sums[s][lane]);
  }

  void solve(int lane) {
    const auto sum = [&](int which) { return sums_[which][lane]; };
    Plane& fit = planes_[lane];
    done_[lane] = true;  // reset below if the fit succeeds
    fit.inliers = 0;
    const double n = sum(kN), pixels = n * rows_for_one_[lane];
    if (n < 1 || pixels < window_.min_inliers) return;
    const double each = 1 / n, x = sum(kX) * each, y = sum(kY) * each, r = sum(kR) * each;
    const double cxx = sum(kXX) - sum(kX) * x, cxy = sum(kXY) - sum(kX) * y, cyy = sum(kYY) - sum(kY) * y;
    const double cxr = sum(kXR) - sum(kX) * r, cyr = sum(kYR) - sum(kY) * r;
    const double det = cxx * cyy - cxy * cxy;
    if (det < 1e-6 * n * n) return;
    const double a = (cyy * cxr - cxy * cyr) / det, b = (cxx * cyr - cxy * cxr) / det;
    const double rss = sum(kRR) - sum(kR) * r - a * cxr - b * cyr;
    fit.q += static_cast<float>(r - a * (x + to_x_[lane]) - b * (y + to_y_[lane]));
    fit.du += static_cast<float>(a);
    fit.dv += static_cast<float>(b);
    fit.variance = rss > 0 ? static_cast<float>(rss * each) : 0;
    fit.inliers = static_cast<int>(pixels + 0.5);
    first_[lane] = fit.q + fit.du * static_cast<float>(to_x_[lane]) + fit.dv * static_cast<float>(to_y_[lane]);
    du_[lane] = fit.du, dv_[lane] = fit.dv;
    done_[lane] = n == before_[lane];  // as many pixels as before, so the next pass would change nothing
    before_[lane] = n;
  }

  const InverseDepth& image_;
  const PlaneWindow& window_;
  int columns_, rows_, chunk_columns_, chunk_rows_;  ///< of the largest window; only the rows that are read
  alignas(64) float staged_[kStaged][W];
  float left_[W], top_[W], last_column_[W], last_row_[W];
  float first_[W], du_[W], dv_[W], gate_[W];
  int to_x_[W], to_y_[W];
  double rows_for_one_[W], before_[W], sums_[kSums][W];
  bool done_[W];
  Plane planes_[W];
};

template <typename V>
void fit_planes(const InverseDepth& image, const PlaneWindow& window, const PlaneSeed* seeds, int count,
                Plane* planes) {
  for (int i = 0; i < count; ++i) planes[i] = Plane{};
  if (image.width <= 0 || image.height <= 0) return;
  PlaneFitter<V> fit(image, window);
  for (int i = 0; i < count; i += V::W) fit(seeds + i, count - i < V::W ? count - i : V::W, planes + i);
}

}  // namespace dot::kernel
