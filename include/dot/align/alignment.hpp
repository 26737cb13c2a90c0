// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "dot/align/reduction.hpp"

DOT_BEGIN_NAMESPACE

/// Result of an alignment.
struct Alignment {
  AlignState state;                      ///< T = T_i_j
  Matrix8 covariance = Matrix8::Zero();  ///< of [x; a; b], from the points and the prior
  /// x that a unit of each depth error mode causes (NormalEquations::modes)
  std::array<Vector8, 4> depth_modes{Vector8::Zero(), Vector8::Zero(), Vector8::Zero(), Vector8::Zero()};
  double sigma_intensity = 0;  ///< grey values, level 0
  double reduced_chi2 = 0;     ///< of the inliers' residuals over their predicted sigma; near 1 if consistent
  double phi = 0;              ///< Pearson correlation of the inliers
  int inside = 0;              ///< points inside the image: seen or occluded
  int seen = 0;                ///< points that nothing hides
  int occluded = 0;            ///< points behind something nearer
  int inliers = 0;             ///< seen points that fit the line between intensities
  int with_depth = 0;          ///< seen points with measured depth
  int depth_agrees = 0;        ///< those of them whose depth agrees with the prediction
  double depth_scatter = 0;    ///< robust sigma of measured minus predicted inverse depth, 1/m; 0 if there is no depth
  double depth_shift = 0;      ///< median of these differences
  double depth_spread = 0;     ///< their robust sigma about the median
  /// Share by which the cost of the next best minimum is higher, if several were compared.
  double margin = std::numeric_limits<double>::infinity();
  /// Of a camera's motion: it is zero, and another one explains a large part of the image (StandingCamera).
  bool stands = false;
  int iterations = 0;      ///< of Gauss-Newton, all levels
  bool converged = false;  ///< on the last level: the last step was small
};

/// Whether the covariance of the motion is valid: finite and positive definite. Rounding errors can make it invalid if
/// a few points constrain the motion weakly.
DOT_INLINE bool has_covariance(const Alignment& a);

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/align/impl/alignment.hpp"
#endif
