// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/align/cell_votes.hpp"
#include "dot/align/minima.hpp"
#include "dot/camera_motion/constant_velocity.hpp"
#include "dot/camera_motion/settings.hpp"
#include "dot/camera_motion/standing_camera.hpp"
#include "dot/camera_motion/turn_search.hpp"

DOT_BEGIN_NAMESPACE

/// What tells of the camera's motion besides the background.
struct MotionEvidence {
  const std::vector<const PointSet*>& objects;  ///< their points in the previous frame; any of them may stand
  SE3d T_points_prev;                           ///< from the previous frame to that of the background's points
  /// Metres by which the motion may differ from the one predicted at constant velocity; infinite: no velocity is known.
  double reach = std::numeric_limits<double>::infinity();
  double steadiness = 0;              ///< 0 to 1: whether the velocity was the same in the intervals before
  const TurnSearch* turns = nullptr;  ///< from the previous frame, for a turn that is not as predicted; null: none
};

/// Chooses the camera's motion among the minima of the background's cost.
///
/// The minimum of least cost is right as long as most texture stands. Noise, rain and shadows make the costs of wrong
/// minima nearly as low. So one that changes a velocity that was steady must be better by a share that grows with the
/// square of the change.
///
/// A wrong minimum can also be the lowest by far. A large object that moves and has no mask is part of the background,
/// and can have more texture than everything else. But it covers only a part of the image, and the objects that stand
/// contradict it. Two minima are in contest if each of them explains a large part of the image. The chosen one is then
/// the one that the camera can reach from its velocity. If it can reach both or none, the cells of the image decide, of
/// the background and of the objects.
class MotionChoice {
 public:
  std::size_t chosen = 0;            ///< place of the chosen motion in `candidates`
  std::optional<std::size_t> rival;  ///< the one in contest with it over which its lead is least, if any
  /// Variance of each component of the chosen motion's left twist, if the votes are close: the squared distance to its
  /// rival, of translation and of rotation. Otherwise zero.
  Vector6<double> added_variance = Vector6<double>::Zero();

  /// Chooses, and sets the margin of the chosen minimum over the next best.
  /// @param candidates at least one, aligned on level 0. @param predicted motion at constant velocity, if it is known.
  template <typename Camera, typename Aligner>
  MotionChoice(const AlignProblem<Camera>& problem, std::vector<Alignment>& candidates, const SE3d& predicted,
               const MotionEvidence& evidence, const CameraSettings& settings, Aligner& aligner,
               MinimaWorkspace& workspace) {
    double sigma = std::numeric_limits<double>::infinity();
    for (const Alignment& a : candidates) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, 0));
    PointCosts& costs = workspace.costs;
    costs.clear();
    for (const Alignment& a : candidates) costs.add(problem, a.state, 0, sigma, aligner);
    const auto change_of = [&](std::size_t i) {
      return change_of_place(candidates[i].state.T * evidence.T_points_prev, predicted * evidence.T_points_prev);
    };
    // A later candidate must be better by a margin, so that equal minima do not alternate.
    chosen = costs.best(settings.multistart_margin, [&](std::size_t i) {
      const double change = change_of(i) / evidence.reach;
      return 1 + evidence.steadiness * kAtReach * std::min(1.0, change * change);
    });

    const auto for_each_other = [&](auto&& visit) {
      for (std::size_t i = 0; i < candidates.size(); ++i)
        if (i != chosen) visit(i, count(problem, candidates, i, sigma, evidence, aligner, workspace));
    };
    const auto can_reach = [&](std::size_t i) { return change_of(i) <= evidence.reach; };
    const auto stands = [&](std::size_t i, const CellVotes::Depths& own, const CellVotes::Depths& others) {
      if (!StandingCamera::is_scene(own, others)) return false;
      AlignState zero = candidates[i].state;
      zero.T = evidence.T_points_prev.inverse();
      std::vector<float>& without = workspace.point_costs;
      aligner.point_costs(problem, zero, 0, sigma, without);
      return StandingCamera::is_zero(problem.points, without, costs.of(i), own, problem.camera.width(),
                                     problem.camera.height(), settings.covariance_scale);
    };
    workspace.point_costs.reserve(problem.points.u.capacity());  // a first contest may come late
    for (int pass = 0; pass < 2; ++pass)  // the second one compares those before the chosen one with it
      for_each_other([&](std::size_t i, const CellVotes& votes) {
        if (votes.second == 0) return;
        bool wins = votes.second > votes.first;
        if (can_reach(i) != can_reach(chosen))
          wins = can_reach(i);
        else if (const bool second_stands = stands(i, votes.second_q, votes.first_q);
                 second_stands != stands(chosen, votes.first_q, votes.second_q))
          wins = second_stands;
        if (wins) chosen = i;
      });
    Alignment& a = candidates[chosen];
    double least = std::numeric_limits<double>::infinity();
    for_each_other([&](std::size_t i, const CellVotes& votes) {
      const bool in_contest = votes.second > 0;
      if (!in_contest &&
          pose_distance(problem.points, problem.camera, candidates[i].state.T, a.state.T) <= kSameMinimum)
        return;
      double lead = in_contest ? 1.0 * votes.first / votes.second : costs.ratio(i, chosen);
      if (in_contest && stands(chosen, votes.first_q, votes.second_q) && !stands(i, votes.second_q, votes.first_q))
        a.stands = true, lead = std::max(lead, kSettled);
      a.margin = std::min(a.margin, std::max(0.0, lead - 1));
      if (in_contest && lead < least) least = lead, rival = i;
    });
    if (least < kMajority) {
      const Vector6<double> d = (candidates[*rival].state.T * a.state.T.inverse()).log();
      added_variance << Vector3<double>::Constant(d.head<3>().squaredNorm()),
          Vector3<double>::Constant(d.tail<3>().squaredNorm());
    }
  }

 private:
  static constexpr double kSameMinimum = 5;  ///< pixels between the points at two that count as one, without a contest
  static constexpr double kAtReach = 0.3;    ///< share of the cost by which a change by the reach or more must win
  static constexpr double kContested = 0.3;  ///< votes of the background for another minimum, over those for the chosen
  static constexpr int kMinVotes = 8;        ///< the same, at least
  static constexpr double kSettled = 2;      ///< lead of a camera that stands, at least
  static constexpr double kMajority = 1.15;  ///< votes over those for the other, below which they are close

  /// Votes for the chosen minimum and for another one; all zero where there is no contest. The depths of their cells
  /// are of the background alone.
  template <typename Camera, typename Aligner>
  CellVotes count(const AlignProblem<Camera>& problem, const std::vector<Alignment>& candidates, std::size_t other,
                  double sigma, const MotionEvidence& evidence, Aligner& aligner, MinimaWorkspace& workspace) const {
    const int width = problem.camera.width(), height = problem.camera.height();
    CellVotes votes;
    votes.add(problem.points, workspace.costs.of(chosen), workspace.costs.of(other), width, height);
    if (votes.second < std::max<double>(kMinVotes, kContested * votes.first)) return {};
    CellVotes of_objects;
    for (const PointSet* object : evidence.objects) {
      const AlignProblem<Camera> seen{*object, problem.image, problem.camera};
      const auto cost = [&](std::size_t i, std::vector<float>& out) {
        AlignState state = candidates[i].state;
        state.T = state.T * evidence.T_points_prev;
        aligner.point_costs(seen, state, 0, sigma, out);
      };
      cost(chosen, workspace.point_costs);
      cost(other, workspace.other_costs);
      of_objects.add(*object, workspace.point_costs, workspace.other_costs, width, height);
    }
    votes.first += of_objects.first, votes.second += of_objects.second;
    return votes;
  }
};

DOT_END_NAMESPACE
