// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/align/minima.hpp"
#include "dot/object_motion/problem.hpp"

DOT_BEGIN_NAMESPACE

/// Finds starts for an object without history: the velocities that fit best on a coarse level.
struct VelocitySearch {
  double speed = 0;  ///< m/s, largest velocity that is tried

  /// Adds them to `starts`.
  template <typename Camera, typename Aligner>
  void find(const ReferencePair& pair, const AlignProblem<Camera>& problem, Aligner& aligner,
            MinimaWorkspace& workspace, std::vector<SE3d>& starts) const {
    const ObjectReference& reference = pair.reference;
    const int levels = std::min(reference.points.levels, problem.image.size());
    const int fine = std::min(kFineLevel, levels - 1);
    // Traffic mostly moves in the direction of the camera.
    starts.push_back(SE3d::translation(pair.camera.T_now_ref.inverse() * reference.centroid - reference.centroid));
    try_grid(pair, problem, fine, kFineSteps, aligner, workspace, starts);
    // A large object may move by many pixels of that level between two frames. Then a coarser level is searched too, if
    // the object still has some structure there.
    const double focal = problem.camera.intrinsics().fx, half_size = 0.5 * std::sqrt(1.0 * reference.area);
    const double pixels = speed * pair.seconds * focal / std::max(kNearest, reference.centroid.z());
    int coarse = fine;
    while (coarse + 1 < levels && half_size > kLeastHalfSize << (coarse + 1) && pixels > kManyPixels << coarse)
      ++coarse;
    if (coarse > fine) try_grid(pair, problem, coarse, kCoarseSteps, aligner, workspace, starts);
  }

 private:
  static constexpr int kFineLevel = 2;                        ///< of the pyramid
  static constexpr int kFineSteps = 8, kCoarseSteps = 16;     ///< to each side
  static constexpr int kLeastHalfSize = 6, kManyPixels = 16;  ///< pixels of a level from which a coarser one helps
  static constexpr int kStepsAlong = 6;                       ///< along the ray, to each side
  static constexpr std::size_t kKept = 3;                     ///< velocities kept of a grid
  static constexpr double kNearest = 0.1;                     ///< metres
  static constexpr double kLeastHalf = 2;                     ///< pixels of a level: lower bound of the half size

  /// Adds the three best velocities of a grid on one level, up to `steps` to each side.
  template <typename Camera, typename Aligner>
  void try_grid(const ReferencePair& pair, const AlignProblem<Camera>& problem, int level, int steps, Aligner& aligner,
                MinimaWorkspace& workspace, std::vector<SE3d>& starts) const {
    const ObjectReference& reference = pair.reference;
    const AlignState still{problem.T_outer, pair.camera.gain, pair.camera.offset};
    const double sigma = aligner.intensity_sigma(problem, still, level);
    // Steps of two pixels of that level sideways. A step along the ray changes the scale: the border moves one pixel.
    const double z = std::max(kNearest, reference.centroid.z()), reach = speed * pair.seconds;
    const double focal = problem.camera.intrinsics().fx / (1 << level);
    const double half_size = std::max(kLeastHalf, 0.5 * std::sqrt(1.0 * reference.area) / (1 << level));
    const double side = std::max(2 * z / focal, reach / steps), along = std::max(z / half_size, reach / kStepsAlong);
    auto& found = workspace.tried;
    found.clear();
    const int n = static_cast<int>(reach / side), m = static_cast<int>(reach / along);
    for (int k = -m; k <= m; ++k)
      for (int i = -n; i <= n; ++i) {
        const SE3d T_o = SE3d::translation(Vector3<double>(i * side, 0, k * along));
        const double cost =
            aligner.tukey_cost(problem, {problem.T_outer * T_o, still.gain, still.offset}, level, sigma);
        if (std::isfinite(cost)) found.push_back({cost, {T_o}});
      }
    keep_cheapest(found, kKept);
    for (const auto& place : found) starts.push_back(place.second.T);
  }
};

DOT_END_NAMESPACE
