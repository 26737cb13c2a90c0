// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Interpolates the inverse depth between sparse measurements, such as those of a lidar, which cover a few percent of
/// the pixels. Each pixel gets the value of the plane q = a + b u + c v through the measurements around it. Pixels
/// between two surfaces get none, because the measurements are not on one plane. Pixels outside all measurements get
/// none.
class DepthDensifier {
 public:
  static constexpr double kSparse = 0.25;  ///< `density` below which an image is sparse

  /// The share of measured pixels in the neighbourhood of measured pixels. It is near 1 even if depth is dense in only
  /// a part of the image. @param q 1/m, <= 0 = not measured. @return 0 if nothing is measured.
  static double density(const Image<float>& q) {
    constexpr int kReach = 12;  // pixels: some beams of a lidar
    double measured = 0, looked_at = 0;
    for_some_measured(q, [&](int x, int y) {
      for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, q.height() - 1); ++v)
        for (int u = std::max(x - kReach, 0); u <= std::min(x + kReach, q.width() - 1); ++u)
          measured += q(u, v) > 0, ++looked_at;
    });
    return looked_at > 0 ? measured / looked_at : 0;
  }

  /// @param sparse 1/m, <= 0 = not measured. @param sigma of one measurement q, 1/m: sigma(q). @param dense of the same
  /// size, is overwritten.
  template <typename Sigma>
  void operator()(const Image<float>& sparse, double density, Sigma&& sigma, Image<float>& dense) {
    const int width = sparse.width(), height = sparse.height();
    choose_window(sparse, density);
    dense.resize(width, height);
    columns_.assign(static_cast<std::size_t>(width), Column{});
    for (int y = -ry_; y < height; ++y) {
      if (y + ry_ < height) add_row(sparse, y + ry_, 1);
      if (y - ry_ - 1 >= 0) add_row(sparse, y - ry_ - 1, -1);
      if (y >= 0) fit_row(sparse, y, sigma, dense);
    }
  }

 private:
  /// Calls visit(x, y) for at most some thousand measured pixels. It does not sample rows, because lidar beams are
  /// rows.
  template <typename Visitor>
  static void for_some_measured(const Image<float>& q, Visitor&& visit) {
    constexpr int kEnough = 2000;
    int count = 0;
    for (int y = 0; y < q.height(); ++y)
      count += static_cast<int>(std::count_if(q.row(y), q.row(y) + q.width(), [](float v) { return v > 0; }));
    const int step = std::max(1, count / kEnough);
    int i = 0;
    for (int y = 0; y < q.height(); ++y)
      for (int x = 0; x < q.width(); ++x)
        if (q(x, y) > 0 && i++ % step == 0) visit(x, y);
  }

  static constexpr double kWanted = 14;       ///< measurements in a window
  static constexpr int kLeast = 6;            ///< measurements that determine a plane
  static constexpr double kSigmas = 1.5;      ///< of one measurement: largest RMS distance from the plane
  static constexpr double kRelief = 0.015;    ///< lower bound of that for curvature, share of inverse depth
  static constexpr double kOffCentre = 0.6;   ///< largest offset of their middle from the pixel, share of the window
  static constexpr double kSlopePrior = 0.1;  ///< square pixels; keeps the plane through one row from tilting
  static constexpr int kMostReach = 40;       ///< pixels

  /// Sums over the measurements of one column, in the rows of the window.
  struct Column {
    double n = 0, v = 0, vv = 0, q = 0, vq = 0, qq = 0;
  };
  /// Sums over the window.
  struct Sums {
    double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0, q = 0, uq = 0, vq = 0, qq = 0;

    void add(const Column& c, double x, double sign) {
      n += sign * c.n, u += sign * x * c.n, uu += sign * x * x * c.n;
      v += sign * c.v, uv += sign * x * c.v, vv += sign * c.vv;
      q += sign * c.q, uq += sign * x * c.q, vq += sign * c.vq, qq += sign * c.qq;
    }
  };

  /// Chooses a window with as many measurements along its rows as along its columns. A lidar's beams are farther apart
  /// than its azimuth steps.
  void choose_window(const Image<float>& q, double density) {
    // How often the neighbour in the row, or in the column, is measured within a few pixels.
    constexpr int kNear = 8;
    double along = 0, across = 0;
    for_some_measured(q, [&](int x, int y) {
      if (x + kNear >= q.width() || y + kNear >= q.height()) return;
      for (int d = 1; d <= kNear; ++d) along += q(x + d, y) > 0, across += q(x, y + d) > 0;
    });
    const double ratio = std::clamp((along + 1) / (across + 1), 0.25, 4.0);
    const double area = kWanted / std::max(density, 1e-3), side = std::sqrt(area);
    rx_ = std::clamp(static_cast<int>(0.5 * side / std::sqrt(ratio)), 2, kMostReach);
    ry_ = std::clamp(static_cast<int>(0.5 * side * std::sqrt(ratio)), 2, kMostReach);
  }

  void add_row(const Image<float>& sparse, int y, double sign) {
    const float* row = sparse.row(y);
    const double v = y;
    for (int x = 0; x < sparse.width(); ++x) {
      if (!(row[x] > 0)) continue;
      Column& c = columns_[static_cast<std::size_t>(x)];
      const double q = static_cast<double>(row[x]);
      c.n += sign, c.v += sign * v, c.vv += sign * v * v;
      c.q += sign * q, c.vq += sign * v * q, c.qq += sign * q * q;
    }
  }

  template <typename Sigma>
  void fit_row(const Image<float>& sparse, int y, Sigma&& sigma, Image<float>& dense) {
    const int width = sparse.width();
    const auto column = [this](int x) -> const Column& { return columns_[static_cast<std::size_t>(x)]; };
    Sums s;
    for (int x = 0; x < std::min(rx_, width); ++x) s.add(column(x), x, 1);
    for (int x = 0; x < width; ++x) {
      if (x + rx_ < width) s.add(column(x + rx_), x + rx_, 1);
      if (x - rx_ - 1 >= 0) s.add(column(x - rx_ - 1), x - rx_ - 1, -1);
      const float fitted = value(s, x, y, sigma), measured = sparse(x, y);
      dense(x, y) = fitted > 0 ? fitted : std::max(measured, 0.f);
    }
  }

  /// Value of the window's plane at the pixel, or 0 if there is no plane.
  template <typename Sigma>
  float value(const Sums& s, double x, double y, Sigma&& sigma) const {
    if (s.n < kLeast - 0.5) return 0;
    const double u = s.u / s.n - x, v = s.v / s.n - y, q = s.q / s.n;
    if (std::abs(u) > kOffCentre * rx_ || std::abs(v) > kOffCentre * ry_) return 0;
    const double mu = s.u / s.n, mv = s.v / s.n;
    const double uu = s.uu / s.n - mu * mu + kSlopePrior, vv = s.vv / s.n - mv * mv + kSlopePrior;
    const double uv = s.uv / s.n - mu * mv, uq = s.uq / s.n - mu * q, vq = s.vq / s.n - mv * q;
    const double det = uu * vv - uv * uv;
    const double b = (vv * uq - uv * vq) / det, c = (uu * vq - uv * uq) / det;
    const double variance = s.qq / s.n - q * q - b * uq - c * vq;
    const double most = std::max(kSigmas * sigma(q), kRelief * q);
    if (variance > most * most) return 0;
    return static_cast<float>(q - b * u - c * v);
  }

  int rx_ = 0, ry_ = 0;  ///< half sizes of the window, pixels
  std::vector<Column> columns_;
};

DOT_END_NAMESPACE
