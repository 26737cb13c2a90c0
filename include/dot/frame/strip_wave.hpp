// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "dot/abi.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// A periodic function over the height of the image, fitted to one value per strip of rows: a constant, a sinusoid of p
/// periods, and its second harmonic if the strips resolve it.
struct StripWave {
  static constexpr std::size_t kStrips = 48;  ///< of equal height
  using Values = std::array<float, kStrips>;  ///< one per strip, from the top
  /// One number for each term of the function.
  using Vector5 = Eigen::Matrix<double, 5, 1>;
  static constexpr float kNone = std::numeric_limits<float>::infinity();  ///< the value of a strip that has none

  double periods = 0;               ///< p: how many fit into the image
  Vector5 terms = Vector5::Zero();  ///< of 1, sin(2 pi p y), cos(2 pi p y), sin(4 pi p y), cos(4 pi p y)
  double explained = 0;  ///< 1 - median distance to the function over that to the median; negative if it fits worse

  /// Of the sinusoid, without the harmonic.
  double amplitude() const { return terms.segment<2>(1).norm(); }
  /// The value at y, from 0 to 1 over the height, without the constant.
  double at(double y) const { return terms.tail<4>().dot(basis(y, true).tail<4>()); }
  /// Middle of a strip.
  static double middle(std::size_t strip) { return (static_cast<double>(strip) + 0.5) / static_cast<double>(kStrips); }

  /// The sinusoid of least squares with from `first` to `last` periods, refined. Without one of at least that amplitude
  /// the result has none.
  static StripWave fit(const Values& values, double first, double last, double least_amplitude) {
    StripWave best, wave;
    Values distances;
    StripWave flat;
    if (!flat.fit_constant(values, distances) || flat.distance(values, distances) < kLeastDistance * least_amplitude)
      return best;
    double least = std::numeric_limits<double>::infinity();
    const auto attempt = [&](double p) {
      wave.periods = p;
      const double cost = wave.solve_sinusoid(values);
      if (cost < least) least = cost, best = wave;
    };
    for (int i = 0; first + i * kStep <= last; ++i) attempt(first + i * kStep);
    double step = kStep;
    for (int i = 0; i < kHalvings; ++i) {
      step /= 2;
      const double middle = best.periods;
      for (const double p : {middle - step, middle + step})
        if (p >= first && p <= last) attempt(p);
    }
    if (best.amplitude() > 0.5 * least_amplitude) best.refine(values);
    return best;
  }

  /// Fits all terms with Huber's weights.
  void refine(const Values& values) {
    Values distances;
    Weights weights = present(values);
    const bool harmonic = 2 * periods * kLeastStripsOfPeriod <= kStrips;
    solve(values, weights, harmonic);
    for (int pass = 0; pass < kPasses; ++pass) {
      const double sigma = kSigmaOfMedian * distance(values, distances) + kLeastSigma;
      for (std::size_t i = 0; i < kStrips; ++i)
        weights[i] = values[i] == kNone ? 0 : std::min(1.0, kHuber * sigma / std::max(1e-9, residual(values, i)));
      solve(values, weights, harmonic);
    }
    StripWave flat;
    if (!flat.fit_constant(values, distances)) return;
    const double about_flat = flat.distance(values, distances);
    explained = about_flat > 0 ? 1 - distance(values, distances) / about_flat : 0;
  }

 private:
  using Weights = std::array<double, kStrips>;

  static constexpr double kPi = 3.14159265358979323846;
  static constexpr double kStep = 0.25;           ///< between periods that are tried: half a turn at the last row
  static constexpr double kLeastDistance = 0.65;  ///< median distance of a sinusoid's values over its amplitude: .71
  static constexpr int kHalvings = 4;             ///< of the step about the best period: 0.05 at the last row
  static constexpr int kPasses = 4;               ///< of reweighting
  static constexpr double kHuber = 1.345;         ///< sigma
  static constexpr double kLeastSigma = 1e-3;     ///< of a strip
  static constexpr std::ptrdiff_t kLeastStrips = kStrips / 2;
  static constexpr double kLeastStripsOfPeriod = 4;

  Vector5 basis(double y, bool harmonic) const {
    const double angle = 2 * kPi * periods * y, s = std::sin(angle), c = std::cos(angle);
    Vector5 x;
    x << 1, s, c, (harmonic ? 2 * s * c : 0), (harmonic ? c * c - s * s : 0);
    return x;
  }
  static Weights present(const Values& values) {
    Weights weights;
    std::transform(values.begin(), values.end(), weights.begin(), [](float v) { return v == kNone ? 0.0 : 1.0; });
    return weights;
  }
  double residual(const Values& values, std::size_t i) const {
    return std::abs(static_cast<double>(values[i]) - terms[0] - at(middle(i)));
  }
  /// Median distance of the values. @param distances is overwritten.
  double distance(const Values& values, Values& distances) const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < kStrips; ++i)
      if (values[i] != kNone) distances[n++] = static_cast<float>(residual(values, i));
    return n ? static_cast<double>(median(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(n))) : 0;
  }
  /// Sets the constant to the median. @return whether there are enough values.
  bool fit_constant(const Values& values, Values& sorted) {
    const auto end = std::remove_copy(values.begin(), values.end(), sorted.begin(), kNone);
    if (end - sorted.begin() < kLeastStrips) return false;
    terms[0] = static_cast<double>(median(sorted.begin(), end));
    return true;
  }
  /// Least squares of the constant and the sinusoid. @return the sum of squares that is left.
  double solve_sinusoid(const Values& values) {
    const double turn = 2 * kPi * periods / static_cast<double>(kStrips), ds = std::sin(turn), dc = std::cos(turn);
    double s = std::sin(0.5 * turn), c = std::cos(0.5 * turn);
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    double sum = 0;
    for (const float value : values) {
      if (value != kNone) {
        const double v = static_cast<double>(value);
        H(0, 0) += 1, H(1, 0) += s, H(2, 0) += c, H(1, 1) += s * s, H(2, 1) += s * c, H(2, 2) += c * c;
        g[0] += v, g[1] += s * v, g[2] += c * v, sum += v * v;
      }
      const double next = s * dc + c * ds;  // the sine and cosine of the next strip
      c = c * dc - s * ds;
      s = next;
    }
    terms.head<3>() = H.ldlt().solve(g);  // reads the lower triangle
    return sum - g.dot(terms.head<3>());
  }
  /// Weighted least squares of all terms.
  void solve(const Values& values, const Weights& weights, bool harmonic) {
    Eigen::Matrix<double, 5, 5> H = 1e-6 * Eigen::Matrix<double, 5, 5>::Identity();
    Vector5 g = Vector5::Zero();
    for (std::size_t i = 0; i < kStrips; ++i) {
      if (weights[i] == 0) continue;
      const Vector5 x = basis(middle(i), harmonic);
      H += weights[i] * x * x.transpose(), g += weights[i] * static_cast<double>(values[i]) * x;
    }
    terms = H.ldlt().solve(g);
  }
};

DOT_END_NAMESPACE
