// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// @file
/// What the kernel that fits planes to inverse depth takes and gives; see points/plane_fit.hpp.

namespace dot::kernel {

/// An image of inverse depth, 1/m, anything not above 0 = none; rows `stride` bytes apart, fewer than 2^31 bytes in
/// all. No byte outside its pixels is read.
struct InverseDepth {
  const float* data = nullptr;
  int width = 0, height = 0;
  std::ptrdiff_t stride = 0;
};

/// Of each window, 2 radius + 1 pixels wide and high, cut off at the image's border.
struct PlaneWindow {
  int radius = 5;       ///< pixels
  int row_step = 1;     ///< of the window's rows, only each so manieth is read; they count for the others
  int min_inliers = 1;  ///< pixels
};

struct PlaneSeed {
  int u = 0, v = 0;  ///< pixels: the window's centre
  float q = 0;       ///< 1/m, near which the surface is searched
  float gate = 0;    ///< 1/m: what is farther from the fit is left out; three times as far from the seed
};

/// A plane in space is linear in inverse depth over the image: q(u, v) = q + du (u - u0) + dv (v - v0).
struct Plane {
  float q = 0;           ///< 1/m at (u0, v0)
  float du = 0, dv = 0;  ///< 1/m per pixel
  float variance = 0;    ///< of the inliers' residuals, 1/m^2
  int inliers = 0;       ///< 0: too few, or they do not determine a plane; the rest means nothing then
};

}  // namespace dot::kernel
