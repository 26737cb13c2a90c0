// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <random>

#include "dot/lie/so3.hpp"

namespace dot::test {

/// Uniform and normal numbers, the same with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}

  /// In [low, high).
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0);
  }
  /// Of mean 0 and the given standard deviation (Box and Muller 1958).
  double normal(double sigma = 1) {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return sigma * radius * std::cos(uniform(0, 6.283185307179586));
  }
  Vector3<double> normal3(double sigma = 1) {
    const double x = normal(sigma), y = normal(sigma);
    return {x, y, normal(sigma)};
  }

 private:
  std::mt19937 bits_;
};

}  // namespace dot::test
