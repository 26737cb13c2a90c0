// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "dot/align/reduction.hpp"
#include "dot/image/depth_pyramid.hpp"
#include "dot/image/pyramid.hpp"

DOT_BEGIN_NAMESPACE

/// An alignment problem: points of a reference are aligned to an image, T_i_j = T_outer T_o.
///
/// The unknown x moves T_o by a left twist about the region's centroid c, T_o <- Tr(c') exp(x) Tr(-c') T_o with
/// c' = T_o c (an object: its rotation error does not leak into metres of translation), or about the camera's origin
/// when `centred` is false (the camera itself: T_outer = 1, T_c <- exp(x) T_c; paper eq. 3).
template <typename Camera>
struct AlignProblem {
  const PointSet& points;                              ///< of the reference
  const Pyramid& image;                                ///< the new image
  const Camera& camera;                                ///< of level 0
  DepthTerm depth{};                                   ///< what the new frame's depth adds to the cost
  SE3d T_outer{};                                      ///< motion after T_o: that of the camera, for an object
  bool centred = false;                                ///< whether x is about `centroid`
  Vector3<double> centroid = Vector3<double>::Zero();  ///< c, camera axes of the reference
  Matrix6<double> prior = Matrix6<double>::Zero();     ///< information of [T_o c - c; log R_o] about zero
  AlignState photometry{};                             ///< expected gain and offset
  double gain_information = 0;                         ///< of the gain about the expected one
  double offset_information = 0;                       ///< of the offset about the expected one
  double unseen_cost = 0;        ///< cost of a hidden point, or one that left the image, for ranking minima
  const Quads* quads = nullptr;  ///< of one level of `image`, to compare many places on it; may be null
  const DepthPyramid* depth_pyramid = nullptr;  ///< of the new frame; null: depth.inverse_depth is used at all levels

  /// The quads at a pyramid level, or null.
  const Quads* quads_at(int level) const { return quads && quads->level == level ? quads : nullptr; }

  /// The depth term at a pyramid level.
  DepthTerm depth_at(int level) const {
    DepthTerm term = depth;
    if (depth_pyramid)
      term.inverse_depth = depth_pyramid->levels[static_cast<std::size_t>(level)].view(), term.level = level;
    return term;
  }

  /// Cost of deviations from the expected gain and offset. Without it a flat region could fit everything by a gain of
  /// zero.
  double photometric_cost(const AlignState& s) const {
    const double a = s.gain - photometry.gain, b = s.offset - photometry.offset;
    return 0.5 * (gain_information * a * a + offset_information * b * b);
  }
};

DOT_END_NAMESPACE
