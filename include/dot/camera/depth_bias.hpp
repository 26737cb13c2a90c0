// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Error of the measured *inverse depth* that depends only on the place in the image, such as that of a stereo pair
/// with a slightly wrong calibration (an error of the disparity d is one of q = d / (f b)). It is a polynomial
///
///     b(s, t) = c0 + c1 s + c2 s^2 + c3 s^3 + c4 s^4 + (c5 + c6 s) t,   s = 2u/width - 1, t = 2v/height - 1.
struct DepthBias {
  static constexpr int kTerms = 7;  ///< number of coefficients
  /// Coefficients, or the factors that belong to them at a pixel.
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  Terms coefficients = Terms::Zero();  ///< 1/m

  /// Whether there is nothing to subtract.
  bool is_zero() const { return coefficients.isZero(0); }

  /// The terms at (s, t).
  static Terms terms(double s, double t) {
    Terms phi;
    phi << 1, s, s * s, s * s * s, s * s * s * s, t, s * t;
    return phi;
  }
  /// Root mean square over the image, 1/m.
  double rms() const {
    constexpr int n = 16;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double b = (*this)((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1);
        sum += b * b;
      }
    return std::sqrt(sum) / n;
  }
  /// The bias at (s, t), 1/m.
  double operator()(double s, double t) const { return coefficients.dot(terms(s, t)); }
};

DOT_END_NAMESPACE
