// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Learns by how much the scale of the depth differs from frame to frame, as that of a network does.
///
/// s is a factor on all inverse depths of a frame. A camera motion and the depth that it predicts for the next frame
/// have the scale of the frame before. So the next frame's depth differs from the prediction by one factor, s_t /
/// s_t-1, all over the background. The sum of the factors' logarithms is log s_t, wrong by a random walk. Its variance
/// about a straight line over the last frames, less what the random walk explains, is that of log s. The line takes up
/// what a bias of the depth does, and a slow change of the scale, which no frame shows. Of the first few frames the
/// factors alone tell: their variance is twice that of log s.
class ScaleJitter {
 public:
  static constexpr std::size_t kFrames = 20;       ///< that count, at most
  static constexpr std::size_t kLeastFrames = 5;   ///< for a line
  static constexpr std::size_t kLeastPatches = 5;  ///< of a comparison

  /// Adds a comparison with the frame before. @param ratios of measured to predicted inverse depth, less 1, of patches
  /// of the background; they are reordered.
  void add(std::vector<float>& ratios) {
    if (ratios.size() < kLeastPatches) return;
    constexpr double kVarianceOfMedian = 1.57;  // of one value, times their number
    const float step = lower_median(ratios.begin(), ratios.end());
    for (float& r : ratios) r = std::abs(r - step);
    const double sigma = static_cast<double>(kSigmaOfMedian * lower_median(ratios.begin(), ratios.end()));
    steps_[next_] = std::log1p(static_cast<double>(step));
    variances_[next_] = kVarianceOfMedian * sigma * sigma / static_cast<double>(ratios.size());
    next_ = (next_ + 1) % kFrames;
    count_ = std::min(count_ + 1, kFrames);
  }

  /// Variance of log s, about that of the scale relative to its mean; 0 before the first comparison.
  double variance() const {
    if (count_ < kLeastFrames) {
      double twice = 0;
      for (std::size_t k = 0; k < count_; ++k)
        twice += (steps_[k] * steps_[k] - variances_[k]) / static_cast<double>(count_);
      return std::max(0.0, twice / 2);
    }
    const double n = static_cast<double>(count_), middle = 0.5 * (n - 1);
    const std::size_t oldest = count_ < kFrames ? 0 : next_;
    double sum = 0, mean = 0, along = 0, squares = 0, noise = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t k = (oldest + i) % kFrames;
      sum += steps_[k];
      mean += sum / n, squares += sum * sum, along += (static_cast<double>(i) - middle) * sum;
      noise += variances_[k] / n;
    }
    const double of_line = n * mean * mean + along * along * 12 / (n * (n * n - 1));
    const double of_walk = n * n / 15 * noise;  // squares of a random walk about its line
    return std::max(0.0, squares - of_line - of_walk) / (n - 2);
  }

 private:
  std::array<double, kFrames> steps_{};      ///< of log s, between frames
  std::array<double, kFrames> variances_{};  ///< of their errors
  std::size_t next_ = 0, count_ = 0;
};

DOT_END_NAMESPACE
