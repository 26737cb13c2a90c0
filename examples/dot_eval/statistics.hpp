// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "run/percentile.hpp"

namespace eval {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// a / b; not a number where b is 0.
inline double ratio(double a, double b) { return b != 0 ? a / b : not_a_number; }

/// Not a number for an empty list, as are the others.
double mean(const std::vector<double>& values);

/// Root of the mean square.
double root_mean_square(const std::vector<double>& values);

using runner::percentile;

/// The mean of the two in the middle where their number is even.
double median(std::vector<double> values);

}  // namespace eval
