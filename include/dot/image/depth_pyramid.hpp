// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"
#include "dot/image/levels.hpp"
#include "dot/kernel/portable_kernels.hpp"

DOT_BEGIN_NAMESPACE

/// Inverse depth at the levels of an image pyramid, 0 = no measurement. A pixel is the mean of those of its 2x2 pixels
/// that belong to the nearest surface among them (kernel::kSameSurface). A mean across a depth edge would be on no
/// surface.
struct DepthPyramid {
  std::vector<Image<float>> levels;  ///< 1/m, 0 = none; level 0 has full size

  /// @param bottom bottom(y, out): row y of level 0, from the top.
  template <typename Bottom>
  void build(int width, int height, Bottom&& bottom, int level_count,
             const kernel::Kernels& kernels = portable_kernels()) {
    build_levels(width, height, level_count, bottom, kernels.halve_depth, levels);
  }
};

DOT_END_NAMESPACE
