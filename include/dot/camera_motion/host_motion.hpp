// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Cholesky>

#include "dot/align/aligner.hpp"
#include "dot/align/cell_votes.hpp"
#include "dot/align/minima.hpp"
#include "dot/camera_motion/camera_step.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "dot/frame/frame.hpp"
#include "dot/lie/se3.hpp"
#include "dot/statistics/chi2.hpp"

DOT_BEGIN_NAMESPACE

/// The host's knowledge of the camera's motion over the last interval.
struct HostMotion {
  std::optional<CameraMotion> motion;           ///< replaces the estimate
  std::optional<std::array<double, 12>> prior;  ///< T_cur_prev, row-major 3x4, start of the estimate

  /// Whether the motion is that of a camera that is mounted for good: exactly none. No image can refute it.
  bool is_mounted() const {
    const CameraMotion none;
    return motion && motion->T_cur_prev == none.T_cur_prev && motion->covariance == none.covariance;
  }
};

/// Whether the image refutes a motion that the host has given, as one that is inverted, in other axes or units, of
/// another interval, or with a covariance that is far too small. It does if
///
/// - the motion that fits the background best is as sure as one of which nothing was known before must be,
/// - it is farther from the host's than both covariances allow,
/// - and hardly any part of the image, as seen in the cells of a grid, is explained better by the host's.
///
/// The last condition protects a right motion: where a lorry or a conveyor without a mask has most texture, what
/// stands beside it speaks for the host.
struct HostMotionCheck {
  /// A first look: whether the alignment that starts at the host's motion fits badly, or leads farther away than the
  /// covariances allow. Nearly all right motions pass. @param few points. @param stated the host's state. @param step
  /// the host's, with its covariance.
  template <typename Camera, typename Aligner>
  static bool doubts(const AlignProblem<Camera>& few, const AlignState& stated, const CameraStep& step,
                     const CameraMotionEstimator& estimator, Aligner& aligner) {
    Alignment a = aligner.align(few, stated, std::min(few.points.levels, few.image.size()) - 1, 0);
    aligner.reject_outliers_and_refit(few, a, true);
    if (!estimator.accepts(a, false)) return true;
    return differ(a.state.T, stated.T,
                  step.covariance + estimator.settings.covariance_scale * a.covariance.topLeftCorner<6, 6>());
  }

  /// Whether the image's own motion refutes the host's. @param own the image's, as estimated without the host. @param
  /// stated the host's state, from the points' frame. @param step the host's, with its covariance.
  template <typename Camera, typename Aligner>
  static bool refutes(const AlignProblem<Camera>& problem, const CameraStep& own, const AlignState& stated,
                      const CameraStep& step, const CameraMotionEstimator& estimator, Aligner& aligner,
                      MinimaWorkspace& workspace) {
    const AlignState& seen = own.alignment.state;
    if (own.status != CameraStatus::Tracked || !estimator.accepts(own.alignment, false) ||
        !differ(seen.T, stated.T, step.covariance + own.covariance))
      return false;
    const double sigma = aligner.intensity_sigma(problem, seen, 0);
    aligner.point_costs(problem, stated, 0, sigma, workspace.point_costs);
    aligner.point_costs(problem, seen, 0, sigma, workspace.other_costs);
    // What the host's motion moves out of the image speaks against it, too.
    const float most = static_cast<float>(aligner.settings.tukey * aligner.settings.tukey / 6);
    for (std::size_t i = 0; i < workspace.point_costs.size(); ++i)
      if (workspace.point_costs[i] < 0) workspace.point_costs[i] = most;
    CellVotes votes;
    votes.add(problem.points, workspace.point_costs, workspace.other_costs, problem.camera.width(),
              problem.camera.height());
    return votes.second >= kMinVotes && votes.first < kContested * votes.second;
  }

 private:
  static constexpr int kMinVotes = 8;        ///< cells for the image's motion
  static constexpr double kContested = 0.1;  ///< votes for the host's, over those: from here on both may be right

  /// Whether the distance of two motions is beyond the sum S of their covariances.
  static bool differ(const SE3d& one, const SE3d& other, const Matrix6<double>& S) {
    const Vector6<double> d = (one * other.inverse()).log();
    return !(d.dot(S.ldlt().solve(d)) <= chi2::k99999Of6);
  }
};

DOT_END_NAMESPACE
