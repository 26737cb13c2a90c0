// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/portable_kernels.hpp"

DOT_BEGIN_NAMESPACE

/// Inverse depth at the levels of an image pyramid, 0 = no measurement. A pixel is the mean of those of its 2x2 pixels
/// that belong to the nearest surface among them (kernel::kSameSurface): a mean across a depth edge would be a surface
/// that does not exist.
struct DepthPyramid {
  std::vector<Image<float>> levels;

  /// Fills the levels above 0, which the caller has filled.
  void build(int level_count, const kernel::Kernels& kernels = portable_kernels()) {
    levels.resize(static_cast<std::size_t>(level_count));
    for (std::size_t l = 1; l < levels.size(); ++l) {
      const Image<float>& below = levels[l - 1];
      levels[l].resize(below.width() / 2, below.height() / 2);
      for (int y = 0; y < levels[l].height(); ++y)
        kernels.halve_depth(below.row(2 * y), below.row(2 * y + 1), levels[l].width(), levels[l].row(y));
    }
  }
};

DOT_END_NAMESPACE
