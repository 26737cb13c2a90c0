// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// @file
/// Input and output of the kernel that fits planes to inverse depth; see points/plane_fit.hpp.

namespace dot::kernel {

/// An image of inverse depth, 1/m, anything not above 0 = none; rows `stride` bytes apart, fewer than 2^31 bytes in
/// all. No byte outside its pixels is read.
struct InverseDepth {
  const float* data = nullptr;
  int width = 0, height = 0;
  std::ptrdiff_t stride = 0;
};

/// Size of each window: 2 radius + 1 pixels wide and high, clipped at the image's border.
struct PlaneWindow {
  int radius = 5;       ///< pixels
  int row_step = 1;     ///< only every row_step-th row of the window is read, and counts for the others
  int min_inliers = 1;  ///< pixels
};

struct PlaneSeed {
  int u = 0, v = 0;  ///< pixels: the window's centre
  float q = 0;       ///< 1/m, approximate value of the surface
  float gate = 0;    ///< 1/m: largest distance of a pixel from the fit; three times as large from the seed
};

/// A plane in space is linear in inverse depth over the image: q(u, v) = q + du (u - u0) + dv (v - v0).
struct Plane {
  float q = 0;           ///< 1/m at (u0, v0)
  float du = 0, dv = 0;  ///< 1/m per pixel
  float variance = 0;    ///< of the inliers' residuals, 1/m^2
  int inliers = 0;       ///< 0: too few, or they do not determine a plane; then the rest is not valid
};

}  // namespace dot::kernel
