// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/edges.hpp"
#include "dot/kernel/gradients.hpp"
#include "dot/kernel/images.hpp"
#include "dot/kernel/photometric.hpp"
#include "dot/kernel/planes.hpp"

/// @file
/// The common signature of the portable and the compiled kernels.

namespace dot::kernel {

/// A set of kernels for one kind of machine. The kernels are reentrant. Results depend on the arguments alone, and
/// differ between the sets only by float rounding.
struct Kernels {
  const char* name;
  void (*residuals)(const Input& in, const Residuals& out);
  void (*costs)(const Input& in, Costs& out);      ///< reads quads for GradientSource::Image
  void (*moments)(const Input& in, Moments& out);  ///< reads quads; needs no gradient, and no depth term
  void (*linearize)(const Input& in, Sums& out);   ///< overwrites `out`
  /// Samples a level of at least 4 x 4 pixels at n points (u, v), pixels of level 0. `scale` is the size of such a
  /// pixel in pixels of the level. Points at the border are moved inside.
  void (*sample)(const Level& level, float scale, const float* u, const float* v, int n, const Samples& out);
  /// Fits a plane robustly to the inverse depth about each of `count` seeds, in three least-squares passes. The first
  /// has a wide gate about the seed, to allow steep planes. The others have the gate about the fit.
  void (*fit_planes)(const InverseDepth& image, const PlaneWindow& window, const PlaneSeed* seeds, int count,
                     Plane* planes);
  /// The largest GradientStrip::key of each column, or the key of `threshold` in row 0 if no gradient is above it.
  void (*strongest_gradients)(const GradientStrip& strip, int threshold, int* keys);
  /// Inverse depth of n values of a row, 1/m; 0 if there is no measurement.
  void (*invert_words)(const unsigned short* values, int n, const DepthUnits& units, float* out);
  void (*invert_floats)(const float* values, int n, const DepthUnits& units, float* out);
  /// Subtracts the bias from n inverse depths; 0 remains 0. `out` must be another row.
  void (*take_bias)(const float* q, int n, const RowBias& bias, float* out);
  /// The mean of those of 2x2 pixels that belong to the nearest surface among them; n pixels of 2 n in each row.
  void (*halve_depth)(const float* upper, const float* lower, int n, float* out);
  /// Blurs five rows of n pixels to one row, in both directions. The pixels at the ends are repeated beyond. Rounded
  /// once.
  void (*blur)(const unsigned char* const* rows, int n, const BlurWeights& weights, unsigned char* out);
  /// The mean of 2x2 pixels, halves rounded up; n pixels of 2 n in each row.
  void (*halve)(const unsigned char* upper, const unsigned char* lower, int n, unsigned char* out);
  /// Adds the change of the gradient, |gx - gx'| + |gy - gy'|, and |gx| + |gy| + |gx'| + |gy'| to n columns.
  void (*compare_edges)(const ThreeRows& now, const ThreeRows& before, int n, const EdgeColumns& columns);
  /// Adds the gradients of n pixels to their sums. Then adds |sum g| and sum |g| of those that are edges to the
  /// columns.
  /// @param stays 1 for an edge of which |sum g| is more than nine tenths of sum |g|, else 0: what is drawn over the
  /// image may be semi-transparent.
  void (*sum_edges)(const ThreeRows& rows, int n, const EdgeSums& sums, const EdgeColumns& columns,
                    unsigned char* stays);
};

}  // namespace dot::kernel
