// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "statistics.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace eval {

double mean(const std::vector<double>& values) {
  return ratio(std::accumulate(values.begin(), values.end(), 0.0), static_cast<double>(values.size()));
}

double root_mean_square(const std::vector<double>& values) {
  return std::sqrt(
      ratio(std::inner_product(values.begin(), values.end(), values.begin(), 0.0), static_cast<double>(values.size())));
}

double median(std::vector<double> values) { return percentile(std::move(values), 50); }

}  // namespace eval
