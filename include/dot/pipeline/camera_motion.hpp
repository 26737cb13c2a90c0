// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Eigenvalues>

#include "dot/align/aligner.hpp"
#include "dot/align/pose_distance.hpp"
#include "dot/align/settings.hpp"

DOT_BEGIN_NAMESPACE

/// Camera motion T_c (paper, section 3.3) that traffic does not capture.
///
/// The contours of cast shadows lie on the road, outside every mask, with correct depth, and move with their cars; near
/// asphalt has little else. Under Huber's cost the motion that follows them can be the lower minimum. So several
/// starts are refined, each a candidate, and the one of least *redescending* cost is taken, all judged with the same
/// residual scale: coarse to fine from constant velocity and, before that, from what the host expects; the same on fine
/// levels only; standing still; and shifts of those along the direction that the points determine least.
struct CameraMotionEstimator {
  CameraSettings settings;

  /// @param predicted T_c, the most trusted first, at least one. Unless the motion is `known`, translations up to
  /// `search` metres along the axes are tried as well. @return the alignment; `covariance` is that of the left twist of
  /// T_c.
  template <typename Camera, typename Aligner>
  Alignment estimate(const PointSet& points, const Pyramid& image, const Camera& camera,
                     const std::vector<SE3d>& predicted, bool known, double search, Aligner& aligner) const {
    const AlignProblem<Camera> problem{points, image, camera};
    const int top = std::min(points.levels, image.size()) - 1, fine = std::min(1, top);
    // On the fine level but one, minima are told apart; the finest is for those that remain.
    Minima minima;
    const auto add = [&](const AlignState& start, int coarsest) {
      const Alignment a = aligner.align(problem, start, coarsest, fine);
      minima.add(problem, a);
      return a.state;
    };
    AlignState first;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
      const AlignState found = add({predicted[i]}, top);
      if (i == 0) first = found;
      add({predicted[i], found.gain, found.offset}, fine);
    }
    if (predicted.back().log().norm() > 1e-3) add({SE3d{}, first.gain, first.offset}, top);
    if (!known)
      for (const SE3d& start : searched(problem, search, first, aligner)) add({start, first.gain, first.offset}, fine);

    const std::size_t unshifted = minima.found.size();
    double sigma = std::numeric_limits<double>::infinity();
    for (const Alignment& a : minima.found) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, fine));
    for (std::size_t i = 0; i < unshifted; ++i)
      for (const AlignState& start : shifted(problem, minima.found[i], fine, sigma, aligner)) add(start, fine);
    std::vector<Alignment>& candidates = minima.found;
    if (fine > 0)
      for (Alignment& a : candidates) a = aligner.align(problem, a.state, 0);
    return best(problem, candidates, aligner);
  }

 private:
  /// Of translations along each axis the four that fit best on a middle level, where their steps are a few pixels.
  template <typename Camera, typename Aligner>
  std::vector<SE3d> searched(const AlignProblem<Camera>& problem, double search, const AlignState& state,
                             Aligner& aligner) const {
    const int level = std::min({2, problem.points.levels - 1, problem.image.size() - 1});
    const double sigma = aligner.intensity_sigma(problem, state, level);
    const double reach = std::min(search, 0.5 * median_depth(problem.points));
    std::vector<std::pair<double, SE3d>> found;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = -24; i <= 24; ++i) {
        const SE3d start = SE3d::translation(Vector3<double>::Unit(axis) * reach * i / 24);
        const double cost = aligner.rank(problem, {start, state.gain, state.offset}, level, sigma);
        if (i != 0 && std::isfinite(cost)) found.push_back({cost, start});
      }
    const auto keep = static_cast<std::ptrdiff_t>(std::min<std::size_t>(found.size(), 4));
    std::partial_sort(found.begin(), found.begin() + keep, found.end(),
                      [](const auto& l, const auto& r) { return l.first < r.first; });
    std::vector<SE3d> starts;
    for (std::ptrdiff_t i = 0; i < keep; ++i) starts.push_back(found[static_cast<std::size_t>(i)].second);
    return starts;
  }

  /// The two best of the starts along the least determined direction, on the road that of travel: as pure translations,
  /// and with rotation, gain and offset following as the covariance says.
  template <typename Camera, typename Aligner>
  std::vector<AlignState> shifted(const AlignProblem<Camera>& problem, const Alignment& a, int level, double sigma,
                                  Aligner& aligner) const {
    const Matrix3<double> C = a.covariance.topLeftCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> eigen(C);
    const Vector3<double> direction = eigen.eigenvectors().col(2);
    const Vector8 follow = a.covariance.leftCols<3>() * C.ldlt().solve(direction);
    Vector8 alone = Vector8::Zero();
    alone.head<3>() = direction;
    if (!follow.allFinite()) return {};
    std::vector<std::pair<double, AlignState>> starts;
    const double reach = std::min(settings.restart_shift, 0.1 * median_depth(problem.points));
    for (const Vector8& x : {alone, follow})
      for (int i = -6; i <= 6; ++i) {
        if (i == 0) continue;
        const Vector8 shift = reach * i / 6 * x;
        const AlignState start{SE3d::exp(shift.head<6>()) * a.state.T, a.state.gain + shift[6],
                               a.state.offset + shift[7]};
        starts.push_back({aligner.rank(problem, start, level, sigma), start});
      }
    std::partial_sort(starts.begin(), starts.begin() + 2, starts.end(),
                      [](const auto& l, const auto& r) { return l.first < r.first; });
    return {starts[0].second, starts[1].second};
  }

  static double median_depth(const PointSet& points) {
    std::vector<float> q = points.q;
    const auto middle = q.begin() + static_cast<std::ptrdiff_t>(q.size() / 2);
    std::nth_element(q.begin(), middle, q.end());
    return 1 / static_cast<double>(*middle);
  }

  /// A later candidate must win by a margin: equal minima should not alternate.
  template <typename Camera, typename Aligner>
  Alignment best(const AlignProblem<Camera>& problem, std::vector<Alignment>& candidates, Aligner& aligner) const {
    double sigma = std::numeric_limits<double>::infinity();
    for (const Alignment& a : candidates) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, 0));
    double least = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double cost = aligner.rank(problem, candidates[i].state, 0, sigma);
      if (cost < least * (1 - settings.restart_margin) || (i == 0 && cost <= least)) least = cost, chosen = i;
    }
    aligner.finish(problem, candidates[chosen]);
    return candidates[chosen];
  }
};

DOT_END_NAMESPACE
