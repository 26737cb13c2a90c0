// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Inverse depth at the levels of an image pyramid, 0 = no measurement. A pixel is the mean of those of its 2x2 pixels
/// that belong to the nearest surface among them: a mean across a depth edge would be a surface that does not exist.
struct DepthPyramid {
  static constexpr float kSameSurface = 0.1f;  ///< relative difference of inverse depth within one surface

  std::vector<Image<float>> levels;

  /// Fills the levels above 0, which the caller has filled.
  void build(int level_count) {
    levels.resize(static_cast<std::size_t>(level_count));
    for (std::size_t l = 1; l < levels.size(); ++l) {
      const Image<float>& below = levels[l - 1];
      levels[l].resize(below.width() / 2, below.height() / 2);
      for (int y = 0; y < levels[l].height(); ++y) {
        const float* upper = below.row(2 * y);
        const float* lower = below.row(2 * y + 1);
        float* out = levels[l].row(y);
        for (int x = 0; x < levels[l].width(); ++x) {
          const float q[4] = {upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]};
          const float limit = (1 - kSameSurface) * std::max(std::max(q[0], q[1]), std::max(q[2], q[3]));
          float sum = 0, n = 0;
          for (const float v : q) {
            const bool same = (v > 0) & (v >= limit);
            sum += same ? v : 0.0f;
            n += same ? 1.0f : 0.0f;
          }
          out[x] = sum / std::max(n, 1.0f);
        }
      }
    }
  }
};

DOT_END_NAMESPACE
