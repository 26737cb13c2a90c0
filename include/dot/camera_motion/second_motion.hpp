// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"
#include "dot/camera_motion/motion_choice.hpp"
#include "dot/camera_motion/search.hpp"

DOT_BEGIN_NAMESPACE

/// The motion of the points that the best motion found so far does not explain, and of the objects. Where the best one
/// is that of a large object without a mask, this is the camera's: while the object's points take part, its minimum is
/// not found. Objects that stand may have most of the texture.
struct SecondMotion {
  static constexpr float kUnexplained = 0.3f;  ///< share of the highest cost of a point
  static constexpr double kMinShare = 0.1;     ///< of the visible points
  static constexpr int kMinPoints = 50;        ///< that another motion must explain
  static constexpr int kPerObject = 100;       ///< points of an object, which may stand

  /// @param problem of some points, as of the search. @param best motion found so far. @param depth of the points,
  /// metres. @param level on which minima are told apart. @param sigma grey values, scale of the residuals there.
  /// @return the state, or nothing where nearly all is explained.
  template <typename Camera, typename Aligner>
  static std::optional<AlignState> find(const AlignProblem<Camera>& problem, const AlignState& best,
                                        const CameraSearch& search, const MotionEvidence& evidence, double depth,
                                        int level, double sigma, Aligner& aligner, MinimaWorkspace& workspace) {
    take_unexplained(problem, best, level, sigma, aligner, workspace);
    PointSet& rest = workspace.unexplained;
    const std::vector<float>& costs = workspace.point_costs;
    const auto seen = std::count_if(costs.begin(), costs.end(), [](float cost) { return cost >= 0; });
    if (rest.size() < kMinPoints || rest.size() < kMinShare * static_cast<double>(seen)) return std::nullopt;

    // Points of one set have one frame.
    if (evidence.T_points_prev.log().isZero())
      for (const PointSet* object : evidence.objects) rest.append_every(1 + object->size() / kPerObject, *object);

    const AlignProblem<Camera> unexplained{rest, problem.image, problem.camera};
    search.find_shifts(unexplained, depth, sigma, CameraSearch::kBrief, aligner, workspace);
    std::optional<AlignState> found;
    double least = std::numeric_limits<double>::infinity();
    search.align_starts(unexplained, level, sigma, CameraSearch::kBrief, aligner, workspace, [&](const Alignment& a) {
      if (2 * a.seen < rest.size() || !a.state.T.t.allFinite()) return;
      const double cost = aligner.tukey_cost(unexplained, a.state, level, sigma);
      if (cost < least) least = cost, found = a.state;
    });
    return found;
  }

  /// Sets workspace.unexplained to the visible points that a motion does not explain. @param sigma grey values, scale
  /// of the residuals on the level.
  template <typename Camera, typename Aligner>
  static void take_unexplained(const AlignProblem<Camera>& problem, const AlignState& motion, int level, double sigma,
                               Aligner& aligner, MinimaWorkspace& workspace) {
    std::vector<float>& costs = workspace.point_costs;
    aligner.point_costs(problem, motion, level, sigma, costs);
    const float most = static_cast<float>(aligner.settings.tukey * aligner.settings.tukey / 6);
    workspace.unexplained.take_if(problem.points, [&](std::size_t i) { return costs[i] > kUnexplained * most; });
  }
};

DOT_END_NAMESPACE
