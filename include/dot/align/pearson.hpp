// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Pearson's correlation coefficient phi, accumulated (paper, section 3.4): invariant to gain and offset.
struct Pearson {
  double n = 0;       ///< pairs
  double mean_x = 0;  ///< mean of x
  double mean_y = 0;  ///< mean of y
  double xx = 0;      ///< sum of squares about mean_x
  double xy = 0;      ///< sum of products about the means
  double yy = 0;      ///< sum of squares about mean_y

  /// Adds a pair (Welford's update, which avoids cancellation).
  void add(double x, double y) {
    n += 1;
    const double dx = x - mean_x, dy = y - mean_y;
    mean_x += dx / n;
    mean_y += dy / n;
    xx += dx * (x - mean_x);
    yy += dy * (y - mean_y);
    xy += dx * (y - mean_y);
  }

  /// In [-1, 1]; 0 if one of the two is constant.
  double correlation() const { return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : 0; }

  /// Slope of the least-squares line y = slope x + intercept.
  double slope() const { return xx > 0 ? xy / xx : 0; }
  /// Intercept of that line.
  double intercept() const { return mean_y - slope() * mean_x; }
};

DOT_END_NAMESPACE
