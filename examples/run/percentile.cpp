// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "percentile.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace runner {

double percentile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double position = q / 100 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  std::sort(values.begin(), values.end());
  const double share = position - static_cast<double>(below);
  // Equal values need no arithmetic, which infinite ones would not survive.
  return values[below] == values[above] || share == 0 ? values[below]
                                                      : values[below] + share * (values[above] - values[below]);
}

}  // namespace runner
