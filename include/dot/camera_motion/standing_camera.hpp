// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "dot/align/cell_votes.hpp"
#include "dot/points/point_set.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// Tells a camera that stands before a large moving object from one that moves, where a motion of zero explains a part
/// of the image and another motion the rest.
///
/// A camera that stands has the motion zero, exactly. Another body seldom moves as the camera does, to within the error
/// of an alignment. What is fixed to the camera does, as a robot's own parts or a bonnet. But it hides what moves, so
/// it is nearer.
struct StandingCamera {
  /// Whether a motion is zero within its error: what it explains, no motion explains as well. What moves pulls the
  /// minimum away from zero, so only the cells that the motion won count. Their cost rises by half of the squared
  /// Mahalanobis distance.
  /// @param cost_zero, cost_found of each point without motion and with it; negative where it is not seen.
  /// @param staying of the cells that the motion won. @param covariance_scale of an alignment's covariance.
  static bool is_zero(const PointSet& points, const std::vector<float>& cost_zero, const std::vector<float>& cost_found,
                      const CellVotes::Depths& staying, int width, int height, double covariance_scale) {
    constexpr int kLeastPoints = 50;
    double rise = 0;
    int compared = 0;
    for (std::size_t i = 0; i < cost_zero.size(); ++i)
      if (cost_zero[i] >= 0 && cost_found[i] >= 0 && staying[CellVotes::cell_of(points, i, width, height)] > 0)
        ++compared, rise += static_cast<double>(cost_zero[i] - cost_found[i]);
    return compared >= kLeastPoints && rise < 0.5 * covariance_scale * chi2::k99999Of6;
  }

  /// Whether the cells that stay are a scene: they are many, and not nearer than what moves.
  /// @param staying, moving inverse depth of the cells of each kind, 0 for others.
  static bool is_scene(const CellVotes::Depths& staying, const CellVotes::Depths& moving) {
    constexpr std::size_t kOfImage = 4;  // one cell in so many must stay
    constexpr std::size_t kFar = 4;      // of these, one in so many must be as far as half of what moves
    CellVotes::Depths q;
    const auto end = std::copy_if(moving.begin(), moving.end(), q.begin(), [](float each) { return each > 0; });
    const auto middle = q.begin() + (end - q.begin()) / 2;
    if (middle == end) return false;
    std::nth_element(q.begin(), middle, end);
    std::size_t stay = 0, far = 0;
    for (const float each : staying) stay += each > 0, far += each > 0 && each <= *middle;
    return stay * kOfImage > staying.size() && far * kFar > stay;
  }
};

DOT_END_NAMESPACE
