// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dot/abi.hpp"
#include "dot/frame/depth_measurements.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Interpolates the inverse depth between sparse measurements, such as those of a lidar, which cover a few percent of
/// the pixels. The pixels of each block of 2x2 get the values of the plane q = a + b u + c v through the measurements
/// around the block. Pixels between two surfaces get none, because the measurements are not on one plane. Pixels
/// outside all measurements get none.
///
/// Measurements that are far apart, such as the map points of a SLAM host or the pixels of a small time-of-flight
/// camera, say little of what lies between them: many of the planes would go through several surfaces. Each of them is
/// the depth of a few pixels about it instead.
class DepthDensifier {
 public:
  static constexpr double kSparse = 0.25;  ///< `density` below which an image is sparse

  /// The share of measured pixels in the neighbourhood of measured pixels. It is near 1 even if depth is dense in only
  /// a part of the image. @param q 1/m, <= 0 = not measured. @return 0 if nothing is measured.
  static double density(const Image<float>& q) {
    constexpr int kReach = 12;    // pixels: some beams of a lidar
    constexpr int kPlaces = 500;  // neighbouring places tell the same
    int count = 0, visited = 0, measured = 0, looked_at = 0;
    // Rows are not sampled, because lidar beams are rows.
    for (int y = 0; y < q.height(); ++y)
      count += static_cast<int>(std::count_if(q.row(y), q.row(y) + q.width(), [](float v) { return v > 0; }));
    const int step = std::max(1, count / kPlaces);
    const auto look_about = [&](int x, int y) {
      const int begin = std::max(x - kReach, 0), end = std::min(x + kReach + 1, q.width());
      for (int v = std::max(y - kReach, 0); v <= std::min(y + kReach, q.height() - 1); ++v) {
        measured += static_cast<int>(std::count_if(q.row(v) + begin, q.row(v) + end, [](float m) { return m > 0; }));
        looked_at += end - begin;
      }
    };
    for (int y = 0; y < q.height(); ++y)
      for (int x = 0; x < q.width(); ++x)
        if (q(x, y) > 0 && visited++ % step == 0) look_about(x, y);
    return looked_at > 0 ? static_cast<double>(measured) / looked_at : 0;
  }

  /// @param sparse 1/m, <= 0 = not measured. @param sigma of one measurement q, 1/m: sigma(q). @param measured gets the
  /// measurements if they are far apart, else nothing. @param dense of the same size, is overwritten.
  template <typename Sigma>
  void operator()(const Image<float>& sparse, double density, Sigma&& sigma, DepthMeasurements& measured,
                  Image<float>& dense) {
    const int width = sparse.width(), height = sparse.height();
    measured.list(sparse);
    dense.resize(width, height);
    if (!choose_window(sparse, density, measured)) return spread(measured, dense);
    columns_.assign(static_cast<std::size_t>((width + 1) / 2), Sums{});
    const int rows = (height + 1) / 2;
    for (int row = -ry_; row < rows; ++row) {
      if (row + ry_ < rows) add_row(measured, row + ry_, 1);
      if (row - ry_ - 1 >= 0) add_row(measured, row - ry_ - 1, -1);
      if (row >= 0) fit_row(sparse, row, sigma, dense);
    }
    measured.clear();
  }

 private:
  static constexpr double kWanted = 16;       ///< measurements in a window
  static constexpr int kLeast = 6;            ///< measurements that determine a plane
  static constexpr double kSigmas = 1.5;      ///< of one measurement: largest RMS distance from the plane
  static constexpr double kRelief = 0.015;    ///< lower bound of that for curvature, share of inverse depth
  static constexpr double kOffCentre = 0.6;   ///< largest offset of their middle, share of the window's half size
  static constexpr double kSlopePrior = 0.1;  ///< square pixels; keeps the plane through one row from tilting
  static constexpr int kMostReach = 20;       ///< blocks
  // A wider window seldom shows one surface. In a finer image the same surface has more pixels.
  static constexpr double kSurface = 20;            ///< pixels
  static constexpr double kSurfaceShare = 0.03125;  ///< of the image's width, if that is more
  static constexpr int kPatch = 3;                  ///< pixels on each side of a measurement that is alone

  /// Sums over measurements (u, v, q).
  struct Sums {
    enum : std::size_t { kN, kU, kV, kUu, kUv, kVv, kQ, kUq, kVq, kQq, kCount };
    std::array<double, kCount> of{};

    void add(double u, double v, double q, double sign) {
      const std::array<double, kCount> terms{1, u, v, u * u, u * v, v * v, q, u * q, v * q, q * q};
      for (std::size_t k = 0; k < kCount; ++k) of[k] += sign * terms[k];
    }
    void add(const Sums& other) {
      for (std::size_t k = 0; k < kCount; ++k) of[k] += other.of[k];
    }
    void subtract(const Sums& other) {
      for (std::size_t k = 0; k < kCount; ++k) of[k] -= other.of[k];
    }
  };

  /// The inverse depth q + b (u - mu) + c (v - mv) about the middle (mu, mv) of the measurements.
  struct Plane {
    double mu = 0, mv = 0, q = 0, b = 0, c = 0;
    float operator()(double u, double v) const { return static_cast<float>(q + b * (u - mu) + c * (v - mv)); }
  };

  /// Chooses a window with as many measurements along its rows as along its columns. A lidar's beams are farther apart
  /// than its azimuth steps.
  /// @return whether the window is small enough for one surface. That of a lidar may be wider: along its beams the
  /// measurements are close together, and show where a surface ends.
  bool choose_window(const Image<float>& q, double density, const DepthMeasurements& measured) {
    // How often the neighbour in the row, or in the column, is measured within a few pixels.
    constexpr int kNear = 8;
    constexpr std::size_t kPlaces = 2000;
    const std::size_t step = std::max<std::size_t>(1, measured.all.size() / kPlaces);
    double along = 0, across = 0;
    for (std::size_t i = 0; i < measured.all.size(); i += step) {
      const int x = measured.all[i].x, y = measured.all[i].y;
      if (x + kNear >= q.width() || y + kNear >= q.height()) continue;
      for (int d = 1; d <= kNear; ++d) along += q(x + d, y) > 0, across += q(x, y + d) > 0;
    }
    const double ratio = std::clamp((along + 1) / (across + 1), 0.25, 4.0);
    const double area = kWanted / std::max(density, 1e-3), side = std::sqrt(area);
    const auto half = [](double pixels) {  // of a window of 2 half + 1 blocks
      return std::clamp(static_cast<int>((pixels - 1) / 4), 1, kMostReach);
    };
    rx_ = half(side / std::sqrt(ratio));
    ry_ = half(side * std::sqrt(ratio));
    return side <= std::max(kSurface, kSurfaceShare * q.width()) || are_on_lines(q, density, measured);
  }

  /// Whether nearly all measurements have a neighbour that is less than half as far away as if they were spread evenly.
  static bool are_on_lines(const Image<float>& q, double density, const DepthMeasurements& measured) {
    constexpr double kNearlyAll = 0.8;
    constexpr std::size_t kPlaces = 1000;
    const int reach = static_cast<int>(0.5 / std::sqrt(density));
    const auto has_neighbour = [&](const DepthMeasurements::Measurement& m) {
      for (int y = std::max(m.y - reach, 0); y <= std::min(m.y + reach, q.height() - 1); ++y)
        for (int x = std::max(m.x - reach, 0); x <= std::min(m.x + reach, q.width() - 1); ++x)
          if (q(x, y) > 0 && (x != m.x || y != m.y)) return true;
      return false;
    };
    const std::size_t step = std::max<std::size_t>(1, measured.all.size() / kPlaces);
    int places = 0, beside = 0;
    for (std::size_t i = 0; i < measured.all.size(); i += step) ++places, beside += has_neighbour(measured.all[i]);
    return beside >= kNearlyAll * places;
  }

  /// Gives the pixels about each measurement its depth. Where two are near, the nearer one counts.
  static void spread(const DepthMeasurements& measured, Image<float>& dense) {
    dense.fill(0);
    for (int reach = kPatch; reach >= 0; --reach)
      for (const DepthMeasurements::Measurement& m : measured.all)
        for (int y = std::max(m.y - reach, 0); y <= std::min(m.y + reach, dense.height() - 1); ++y)
          for (int x = std::max(m.x - reach, 0); x <= std::min(m.x + reach, dense.width() - 1); ++x) dense(x, y) = m.q;
  }

  /// Adds a row of blocks to the sums of the columns.
  void add_row(const DepthMeasurements& measured, int row, double sign) {
    const std::vector<std::size_t>& begin = measured.begin;
    const std::size_t top = 2 * static_cast<std::size_t>(row), end = std::min(top + 2, begin.size() - 1);
    for (std::size_t i = begin[top]; i < begin[end]; ++i) {
      const DepthMeasurements::Measurement& m = measured.all[i];
      columns_[static_cast<std::size_t>(m.x) / 2].add(m.x, m.y, static_cast<double>(m.q), sign);
    }
  }

  template <typename Sigma>
  void fit_row(const Image<float>& sparse, int row, Sigma&& sigma, Image<float>& dense) {
    const int blocks = static_cast<int>(columns_.size()), width = sparse.width();
    const auto column = [this](int i) -> const Sums& { return columns_[static_cast<std::size_t>(i)]; };
    Sums sums;
    for (int i = 0; i < std::min(rx_, blocks); ++i) sums.add(column(i));
    for (int i = 0; i < blocks; ++i) {
      if (i + rx_ < blocks) sums.add(column(i + rx_));
      if (i - rx_ - 1 >= 0) sums.subtract(column(i - rx_ - 1));
      Plane plane;
      const bool is_plane = fit(sums, 2 * i + 0.5, 2 * row + 0.5, sigma, plane);
      for (int y = 2 * row; y < std::min(2 * row + 2, sparse.height()); ++y)
        for (int x = 2 * i; x < std::min(2 * i + 2, width); ++x) {
          const float fitted = is_plane ? plane(x, y) : 0;
          dense(x, y) = fitted > 0 ? fitted : std::max(sparse(x, y), 0.f);
        }
    }
  }

  /// @param x, y the middle of the window. @return whether its measurements are on a plane about there.
  template <typename Sigma>
  bool fit(const Sums& sums, double x, double y, Sigma&& sigma, Plane& plane) const {
    const auto& s = sums.of;
    if (s[Sums::kN] < kLeast - 0.5) return false;
    const double share = 1 / s[Sums::kN], mu = share * s[Sums::kU], mv = share * s[Sums::kV], q = share * s[Sums::kQ];
    if (std::abs(mu - x) > kOffCentre * (2 * rx_ + 1) || std::abs(mv - y) > kOffCentre * (2 * ry_ + 1)) return false;
    const double uu = share * s[Sums::kUu] - mu * mu + kSlopePrior, vv = share * s[Sums::kVv] - mv * mv + kSlopePrior;
    const double uv = share * s[Sums::kUv] - mu * mv;
    const double uq = share * s[Sums::kUq] - mu * q, vq = share * s[Sums::kVq] - mv * q;
    const double by_det = 1 / (uu * vv - uv * uv);
    plane = {mu, mv, q, by_det * (vv * uq - uv * vq), by_det * (uu * vq - uv * uq)};
    const double variance = share * s[Sums::kQq] - q * q - plane.b * uq - plane.c * vq;
    const double most = std::max(kSigmas * sigma(q), kRelief * q);
    return !(variance > most * most);
  }

  int rx_ = 0, ry_ = 0;        ///< half sizes of the window, blocks of 2x2 pixels, without the middle one
  std::vector<Sums> columns_;  ///< of each column of blocks, in the rows of the window
};

DOT_END_NAMESPACE
