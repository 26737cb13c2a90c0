// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Input of the kernels that tell which edges stay in the image; see camera_motion/standing_edges.hpp.

namespace dot::kernel {

/// A row of an image between two others. Of the middle one, a pixel more is read at each end.
struct ThreeRows {
  const unsigned char* above = nullptr;
  const unsigned char* here = nullptr;
  const unsigned char* below = nullptr;
};

/// Sums of gradients (gx, gy) and of their lengths |g| = |gx| + |gy| over the frames, for each pixel of a row.
/// Gradients are central differences without the factor 1/2.
struct EdgeSums {
  short* x = nullptr;  ///< in 1 / kEdgeUnit grey values, as the others
  short* y = nullptr;
  short* length = nullptr;  ///< at most 16383: four lengths must fit into 16 bits

  short fade = 0;  ///< share of the sums that the next frame drops, in 1 / 2^16; below a half
  short edge = 0;  ///< least length of an edge
};
inline constexpr int kEdgeUnit = 2;  ///< of the sums, over grey values

/// What is added to the columns of an image, without overflow for four rows.
struct EdgeColumns {
  unsigned short* part = nullptr;
  unsigned short* all = nullptr;
};

}  // namespace dot::kernel
