// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"
#include "dot/camera_motion/constant_velocity.hpp"
#include "dot/camera_motion/turn_search.hpp"

DOT_BEGIN_NAMESPACE

/// Finds starts for a camera that turns otherwise than at constant velocity: in a hand, on a vehicle that shakes, on a
/// robot that looks about. A turn easily moves the whole image further than the alignment reaches, while the camera's
/// place changes as steadily as before. So only the turn is searched. TurnSearch finds some that fit distant points.
/// Each of them is improved with the true depths, at the places that are expected.
struct UnexpectedTurn {
  /// Whether a pose T_cur_points turns the points otherwise than the predicted one, beyond the reach of an alignment on
  /// the fine levels.
  template <typename Camera>
  static bool is_in(const PointSet& points, const Camera& camera, const SE3d& T, const SE3d& predicted) {
    return !is_near(points, camera, SE3d{T.R, predicted.t}, predicted, kReached);
  }

  /// Sets workspace.starts to poses T_cur_points, the best first.
  /// @param problem of some of the points. @param predicted T_cur_prev at constant velocity. @param T_prev_points from
  /// the points' frame to the previous one. @param sigma grey values, scale of the residuals. @param fine level of the
  /// pyramid down to which the starts are improved.
  template <typename Camera, typename Aligner>
  static void find(const TurnSearch& search, const AlignProblem<Camera>& problem, const SE3d& predicted,
                   const SE3d& T_prev_points, double sigma, int fine, Aligner& aligner, MinimaWorkspace& workspace) {
    search.find(problem.image, problem.camera, aligner, workspace);
    auto& tried = workspace.tried;
    tried.clear();
    for (std::size_t i = 1; i < workspace.turns.size(); ++i) {  // the first is no turn
      const AlignState& turn = workspace.turns[i].second;
      for (const Vector3<double>& place : places_at_constant_velocity(predicted)) {
        const SE3d T_cur_prev{turn.T.R, -(turn.T.R * place)};
        tried.push_back(improved(problem, turn.at(T_cur_prev * T_prev_points), sigma, fine, aligner));
      }
    }
    keep_cheapest(tried, kStarts);
    workspace.starts.clear();
    for (const auto& start : tried) workspace.starts.push_back(start.second);
  }

 private:
  static constexpr double kReached = 4;      ///< pixels; two of the level on which minima are compared
  static constexpr int kCoarse = 2;          ///< level on which the improvement begins
  static constexpr int kRounds = 2;          ///< of small turns about both axes, on each level
  static constexpr int kSteps = 3;           ///< to each side, one pixel of the level each
  static constexpr std::size_t kStarts = 2;  ///< that are kept

  /// Moves a start to the best of several small turns about one axis, then about the other. @return with its cost
  template <typename Camera, typename Aligner>
  static std::pair<double, AlignState> improved(const AlignProblem<Camera>& problem, const AlignState& start,
                                                double sigma, int fine, Aligner& aligner) {
    std::pair<double, AlignState> best{0, start};
    for (int level = std::max(fine, std::min(kCoarse, problem.points.levels - 1)); level >= fine; --level) {
      const auto cost = [&](const AlignState& state) { return aligner.tukey_cost(problem, state, level, sigma); };
      const double pixel = (1 << level) / problem.camera.intrinsics().fx;
      best.first = cost(best.second);
      for (int round = 0; round < 2 * kRounds; ++round) {
        const AlignState from = best.second;
        for (int i = -kSteps; i <= kSteps; ++i) {
          if (i == 0) continue;
          const Vector3<double> turn = i * pixel * Vector3<double>::Unit(round % 2);
          const AlignState there = from.at(SE3d{so3::exp(turn), Vector3<double>::Zero()} * from.T);
          if (const double c = cost(there); c < best.first) best = {c, there};
        }
      }
    }
    return best;
  }
};

DOT_END_NAMESPACE
