// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "dot/lie/se3.hpp"

namespace dot::bench {

/// Milliseconds of processor time that `work` takes, of all threads of this process: others on the machine would add to
/// the time on the clock, and more to what takes long.
template <typename Work>
double milliseconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The value below which a share of `values` lies; 0.5 is the median. 0 of none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(at);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}
inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// How far a pose is from the true one.
struct PoseError {
  double metres = 0, degrees = 0;
};
inline PoseError pose_error(const SE3d& T, const SE3d& truth) {
  const SE3d off = T * truth.inverse();
  return {off.t.norm(), so3::log(off.R).norm() * 180 / 3.14159265358979};
}

}  // namespace dot::bench
