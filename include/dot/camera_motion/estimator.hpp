// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Eigenvalues>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"
#include "dot/align/sharper_image.hpp"
#include "dot/camera_motion/camera_step.hpp"
#include "dot/camera_motion/motion_choice.hpp"
#include "dot/camera_motion/search.hpp"
#include "dot/camera_motion/second_motion.hpp"
#include "dot/camera_motion/settings.hpp"
#include "dot/camera_motion/unexpected_turn.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// Camera motion T_c (paper, section 3.3), robust against traffic and its shadows.
///
/// The contours of cast shadows lie on the road, outside every mask, and have correct depth, but move with their cars.
/// Near asphalt has little other texture. Under Huber's cost the motion that follows the shadows can be the lower
/// minimum. So several starts are refined to candidates, and the candidate of least *redescending* cost is taken. All
/// are judged with the same residual scale and by the points that both see (PointCosts). The starts are, coarse to
/// fine, the host's prediction first and then constant velocity; the same on fine levels only; no motion; and shifts of
/// the minima along the direction that the points determine least. On fine levels only the points that fit a start
/// refine it, because Huber's cost may have no minimum at the true motion.
///
/// Without a known velocity the lowest minimum may be one of many. On an even road, no motion, or a motion further by
/// the spacing of the road markings, fits nearly as well as the true one. `accepts` then requires a better correlation,
/// and that no other motion explains the image about as well.
struct CameraMotionEstimator {
  CameraSettings settings;  ///< conditions for accepting a motion, and the range of the search

  /// @param predicted T_c, the most trusted first, at least one. @param search for other starts if the motion is
  /// unknown, or null. @return the alignment; `covariance` is that of the left twist of T_c, `margin` that over the
  /// next best minimum.
  template <typename Camera, typename Aligner>
  Alignment estimate(const PointSet& points, const Pyramid& image, const Camera& camera,
                     const std::vector<SE3d>& predicted, const CameraSearch* search, const MotionEvidence& evidence,
                     Aligner& aligner, MinimaWorkspace& workspace) const;

  /// Whether the result of `estimate` is trusted. @param known the motion was predicted.
  bool accepts(const Alignment& a, bool known) const {
    return has_covariance(a) && a.state.T.t.allFinite() && a.seen >= settings.min_points &&
           a.inliers >= settings.min_inliers * a.seen &&
           (known ? a.phi >= settings.min_phi
                  : a.phi >= settings.min_phi_unexpected && a.margin >= settings.min_margin);
  }

  /// Sets the motion of a step to one that was accepted. @param problem what it was aligned with.
  /// @param T_prev_points from the points' frame to the one where the step begins.
  template <typename Camera, typename Aligner>
  void set_motion(const AlignProblem<Camera>& problem, const SE3d& T_prev_points, const Aligner& aligner,
                  CameraStep& step) const {
    const Alignment& a = step.alignment;
    step.T_cur_prev = a.state.T * T_prev_points.inverse();
    step.rolling = RollingShutter::measure(problem.points, problem.image.levels[0], problem.camera, a, aligner.settings,
                                           settings.covariance_scale);
    const double sharper =
        SharperImage::variance_factor(problem.points, problem.image.levels[0], problem.camera, a, aligner.settings);
    step.covariance =
        sharper * settings.covariance_scale * a.covariance.topLeftCorner<6, 6>() + step.rolling.covariance_of_all();
  }

  /// Metres by which the motion of an interval may differ from that at constant velocity.
  double reach(double seconds) const { return settings.max_acceleration * seconds * seconds + kShake; }

 private:
  static constexpr double kShake = 0.02;       ///< metres by which two intervals differ at any acceleration
  static constexpr double kMinGain = 0.2;      ///< least ratio of the exposures of two frames
  static constexpr std::size_t kCompared = 8;  ///< minima whose neighbourhood is searched
  static constexpr int kRanked = 500;          ///< points for ranking many places, at least
  static constexpr int kSearched = 800;        ///< the same for a search
  static constexpr int kEnoughRanked = 100;    ///< of these a minimum must see so many, or min_points if fewer
  static constexpr double kSameFine = 0.5;     ///< pixels up to which two minima of a search are one, before level 0
  static constexpr int kStepsAhead = 16;       ///< number of shifts to each side; 5 cm each on a road
  static constexpr int kSteps = 6;             ///< the same along the least determined direction
  static constexpr double kMostCostRatio =
      1.5;  ///< largest cost of a shift over that of its start, of a start over the best

  template <typename Camera, typename Aligner>
  struct Estimation;

  /// Sets the starts to shifts that may lead to other minima. Shifts go along the optical axis, where the near ground
  /// looks alike at small steps, and along the least determined direction, without and with the rotation, gain and
  /// offset that the covariance predicts for it. The two best that fit better than their neighbours are taken. There is
  /// none if the cost only rises.
  template <typename Camera, typename Aligner>
  void shifted(const AlignProblem<Camera>& problem, const Alignment& a, int level, double sigma, double depth,
               Aligner& aligner, MinimaWorkspace& workspace) const {
    std::vector<AlignState>& starts = workspace.starts;
    starts.clear();
    const Matrix3<double> C = a.covariance.topLeftCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(C);
    const Vector3<double> direction = eigen.eigenvectors().col(2);
    const Vector8 follow = a.covariance.leftCols<3>() * C.ldlt().solve(direction);
    Vector8 ahead = Vector8::Zero(), alone = Vector8::Zero();
    ahead[2] = 1;
    alone.head<3>() = direction;
    if (!follow.allFinite()) return;
    const double reach = std::min(settings.multistart_shift, 0.1 * depth);
    const double middle = aligner.tukey_cost(problem, a.state, level, sigma);
    auto& found = workspace.tried;
    found.clear();
    const auto along = [&](const Vector8& x, int steps) {
      const auto start = [&](int i) {
        const Vector8 shift = reach * i / steps * x;
        return AlignState{SE3d::exp(shift.head<6>()) * a.state.T, a.state.gain + shift[6], a.state.offset + shift[7]};
      };
      find_minima(
          steps, [&](int i) { return i == 0 ? middle : aligner.tukey_cost(problem, start(i), level, sigma); },
          [&](double cost, int i) {
            if (i != 0 && cost < kMostCostRatio * middle) found.push_back({cost, start(i)});
          });
    };
    along(ahead, kStepsAhead);
    along(alone, kSteps);
    along(follow, kSteps);
    keep_cheapest(found, 2);
    for (const auto& place : found) starts.push_back(place.second);
  }

  static double median_depth(const PointSet& points, std::vector<float>& q) {
    q = points.q;
    if (q.empty()) return 0;
    return 1 / static_cast<double>(median(q.begin(), q.end()));
  }

  /// The chosen motion, measured again without the points that belong to its rival: they are a large part of all, and
  /// would bias it.
  template <typename Camera, typename Aligner>
  Alignment refined(const MotionChoice& choice, const AlignProblem<Camera>& problem,
                    const std::vector<Alignment>& candidates, Aligner& aligner, MinimaWorkspace& workspace) const {
    const std::vector<float>&cost = workspace.costs.of(choice.chosen), &rivals = workspace.costs.of(*choice.rival);
    PointSet& own = workspace.unexplained;
    const int width = problem.camera.width(), height = problem.camera.height();
    CellVotes votes;
    votes.add(problem.points, cost, rivals, width, height);
    own.take_if(problem.points, [&](std::size_t i) {
      const bool is_rivals =
          rivals[i] >= 0 &&
          (cost[i] > rivals[i] || votes.second_q[CellVotes::cell_of(problem.points, i, width, height)] > 0);
      return !is_rivals;
    });
    const AlignProblem<Camera> rest{own, problem.image, problem.camera};
    Alignment a = aligner.align(rest, candidates[choice.chosen].state, 0, 0);
    a.margin = candidates[choice.chosen].margin;
    a.stands = candidates[choice.chosen].stands;
    aligner.reject_outliers_and_refit(rest, a, true);
    a.covariance.diagonal().template head<6>() += choice.added_variance;
    return a;
  }

  /// Drops minima that are not among the best on a level, or cost much more than the best one.
  template <typename Camera, typename Aligner>
  void keep_best(const AlignProblem<Camera>& problem, int level, double sigma, Aligner& aligner,
                 MinimaWorkspace& workspace) const {
    std::vector<Alignment>&found = workspace.minima.found, &kept = workspace.kept;
    PointCosts& costs = workspace.costs;
    costs.clear();
    for (const Alignment& a : found) costs.add(problem, a.state, level, sigma, aligner);
    kept.clear();
    const std::size_t first = costs.best(0);
    while (kept.size() < std::min(found.size(), kCompared)) {
      const std::size_t next = costs.best(0);
      const auto cost = [&] { return aligner.tukey_cost(problem, found[next].state, level, sigma); };
      if (costs.ratio(next, first) > kMostCostRatio && cost() > kNegligibleCost) break;
      kept.push_back(found[next]);
      costs.remove(next);
    }
    std::swap(kept, found);
  }
};

DOT_END_NAMESPACE

#include "dot/camera_motion/impl/estimator.hpp"
