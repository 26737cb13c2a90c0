// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "dot/kernel/settings.hpp"

/// @file
/// Input and output of the photometric kernels: the factor of align/reduction.hpp for a pinhole camera, with raw
/// pointers. There are only plain structs, so that a unit built for another instruction set shares no code with others.

namespace dot::kernel {

/// Points of the reference, structure of arrays of length `n` without padding or alignment.
struct Points {
  int n = 0;
  const float* x = nullptr;                 ///< ray (x, y, 1), camera axes of the reference
  const float* y = nullptr;                 ///< see x
  const float* q = nullptr;                 ///< inverse depth, 1/m
  const float* sigma_q = nullptr;           ///< its standard deviation, 1/m
  const float* intensity = nullptr;         ///< grey values at this level
  const float* gu = nullptr;                ///< gradient, grey values per pixel of this level; not read for
  const float* gv = nullptr;                ///< GradientSource::Image
  const float* u = nullptr;                 ///< pixels of level 0; read with a depth term only
  const float* v = nullptr;                 ///< see u
  const unsigned char* excluded = nullptr;  ///< non-zero: left out; may be null
};

/// An 8-bit image; rows `stride` bytes apart, fewer than 2^31 bytes in all. No byte outside its pixels is read.
struct Level {
  const unsigned char* data = nullptr;
  int width = 0, height = 0;
  std::ptrdiff_t stride = 0;
  /// The 2x2 pixels from each pixel on, four bytes row by row, `width` of them a row, fewer than 2^31 bytes in all; may
  /// be null. Read by the kernels that compare places: a single load for a point. The gradient is then that of the
  /// bilinear interpolation.
  const unsigned char* quads = nullptr;
};

/// Pinhole camera of the level, pose T_i_j (R row-major) and photometry.
struct View {
  float fx = 1, fy = 1, cx = 0, cy = 0;
  float R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  float t[3] = {0, 0, 0};
  float centre[3] = {0, 0, 0};  ///< metres, camera axes; centre of the rotation's derivatives
  float gain = 1, offset = 0;
};

/// s^2 = s2 + (dr/dq sigma_q)^2 + gradient2 |grad I|^2, see ResidualNoise.
struct Noise {
  float s2 = 25;         ///< sigma_I^2
  float gradient2 = 0;   ///< gradient_noise^2
  float huber = 1.345f;  ///< in sigma
  float tukey = 4.685f;  ///< in sigma
};

/// The term of the measured inverse depth of the new frame, see DepthTerm.
struct Depth {
  const float* data = nullptr;  ///< 1/m, 0 = none
  int width = 0, height = 0;
  std::ptrdiff_t stride = 0;                 ///< bytes
  float scale = 1;                           ///< from pixels of the level (and a half) to those of `data`
  const unsigned char* occluders = nullptr;  ///< non-zero: a nearer object covers the pixel of level 0; may be null
  int occluders_width = 0, occluders_height = 0;
  std::ptrdiff_t occluders_stride = 0;
  float occluders_scale = 1;  ///< to pixels of `occluders`
  float occlusion_relative = 0, occlusion_absolute = 0;
  float sigma = 0, weight = 0;
};

struct Input {
  Points points;
  Level level;
  View view;
  Noise noise;
  const Depth* depth = nullptr;  ///< null: no depth term
  GradientSource gradient = GradientSource::Image;
};

/// One value per point, arrays of the caller of length n. Zero if the point is not seen.
struct Residuals {
  float* r = nullptr;                   ///< grey values
  float* extra = nullptr;               ///< variance besides s2
  float* value = nullptr;               ///< grey value at the moved point
  float* r_depth = nullptr;             ///< measured minus predicted inverse depth, 1/m
  unsigned char* visibility = nullptr;  ///< a sum of the following
};
inline constexpr unsigned char kSeen = 1;      ///< inside the image, in front, not hidden
inline constexpr unsigned char kHasDepth = 2;  ///< r_depth is valid
inline constexpr unsigned char kOccluded = 4;  ///< inside the image, but hidden

/// Tukey's costs of the points that are seen.
struct Costs {
  double sum = 0;  ///< of the residuals, and of the depth residuals times their weight
  int seen = 0;
};

/// Sums over the points that are seen, of the reference's intensity x and the value y at the moved point, both less
/// 128.
struct Moments {
  int seen = 0;
  float x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// Samples of an image at points, arrays of the caller, one value per point.
struct Samples {
  float* value = nullptr;  ///< grey values, bilinear
  float* gu = nullptr;     ///< grey values per pixel: central differences, bilinear
  float* gv = nullptr;     ///< see gu
};

/// Sums over the points, see NormalEquations. For the pose alone, all but the first six rows and columns are zero.
struct Sums {
  double H[64] = {};  ///< 8x8, of [xi; a; b], symmetric
  double g[8] = {};
  double cost = 0;  ///< Huber, sum
  int seen = 0, occluded = 0;
  double modes[4][8] = {};  ///< with a depth term only
};

}  // namespace dot::kernel
