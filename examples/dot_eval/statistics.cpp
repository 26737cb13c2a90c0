// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace eval {

double mean(const std::vector<double>& values) {
  return ratio(std::accumulate(values.begin(), values.end(), 0.0), static_cast<double>(values.size()));
}

double root_mean_square(const std::vector<double>& values) {
  return std::sqrt(
      ratio(std::inner_product(values.begin(), values.end(), values.begin(), 0.0), static_cast<double>(values.size())));
}

double percentile(std::vector<double> values, double q) {
  if (values.empty()) return not_a_number;
  const double position = q / 100 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  std::sort(values.begin(), values.end());
  const double share = position - static_cast<double>(below);
  // Equal values need no arithmetic, which infinite ones would not survive.
  return values[below] == values[above] || share == 0 ? values[below]
                                                      : values[below] + share * (values[above] - values[below]);
}

double median(std::vector<double> values) { return percentile(std::move(values), 50); }

}  // namespace eval
