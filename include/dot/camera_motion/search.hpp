// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"
#include "dot/camera_motion/turn_search.hpp"

DOT_BEGIN_NAMESPACE

/// Finds starts for an unpredicted camera motion. First rotations, see TurnSearch. Then shifts along each axis are
/// tried, with and without these rotations. Then both are refined alternately about the best, since near points shift
/// the image as well. Most of the places are wrong. To see this a part of the points is enough.
struct CameraSearch {
  /// How much is searched: of all points, or of those that a motion found before does not explain.
  struct Effort {
    std::size_t shifts;  ///< that are kept for each rotation
    std::size_t places;  ///< that are kept of all of these, to be refined
    int rounds;          ///< of the refinement about each of them
    int points;          ///< that refine, roughly
  };
  static constexpr Effort kThorough{8, 40, 2, 350};  ///< of all points
  static constexpr Effort kBrief{4, 8, 1, 250};      ///< of those that a motion found before does not explain

  double metres = 0;      ///< largest expected translation of the camera
  double radians = 0;     ///< largest expected rotation of the camera
  const Pyramid& before;  ///< of the previous image
  SE3d T_before_j;        ///< pose of its camera from the points' frame

  /// Sets workspace.starts, poses T_i_j of the problem with the exposure change between the two images.
  /// @param depth of the points, metres; @param sigma grey values, scale of the residuals on level_of(...).
  template <typename Camera, typename Aligner>
  void find(const AlignProblem<Camera>& problem, double depth, double sigma, Aligner& aligner,
            MinimaWorkspace& workspace) const {
    TurnSearch{radians, before}.find(problem.image, problem.camera, aligner, workspace);
    workspace.quads.copy_level(problem.image, level_of(std::min(problem.points.levels, problem.image.size())));
    find_shifts(problem, depth, sigma, kThorough, aligner, workspace);
  }

  /// The same for other points in the same image, with the turns and the quads that `find` left in the workspace.
  template <typename Camera, typename Aligner>
  void find_shifts(const AlignProblem<Camera>& problem, double depth, double sigma, const Effort& effort,
                   Aligner& aligner, MinimaWorkspace& workspace) const {
    const int level = level_of(std::min(problem.points.levels, problem.image.size()));
    auto& tried = workspace.tried;
    tried.clear();
    AlignProblem<Camera> all = problem, scanned = part_of(problem, kScanned, workspace);
    all.quads = scanned.quads = &workspace.quads;
    for (const auto& turn : workspace.turns) {
      const std::size_t others = tried.size();
      add_shifts(scanned, turn.second.at(turn.second.T * T_before_j), depth, sigma, aligner, tried);
      keep_cheapest(tried, effort.shifts + kMore, others);
      for (std::size_t i = others; i < tried.size(); ++i)
        tried[i].first = aligner.tukey_cost(all, tried[i].second, level, sigma);
      keep_cheapest(tried, effort.shifts, others);
    }
    const AlignProblem<Camera> part = part_of(problem, effort.points, workspace);
    for (auto& place : tried) place.first = aligner.tukey_cost(part, place.second, level, sigma);
    keep_cheapest(tried, effort.places);
    keep_comparable(tried, kMostCostRatio);
    for (int round = 0; round < effort.rounds; ++round) {
      for (auto& place : tried) improve(part, depth, sigma, aligner, place);
      keep_comparable(tried, kMostCostRatio);
    }
    workspace.starts.clear();
    for (const auto& place : tried) workspace.starts.push_back(place.second);
  }

  /// Aligns from all starts, and visits the minima that they lead to on the level `fine`, as alignments of all points.
  /// A part of the points finds the minima. The best of them are refined with all.
  /// @param sigma grey values, scale of the residuals that compares these minima.
  template <typename Camera, typename Aligner, typename Visit>
  void align_starts(const AlignProblem<Camera>& problem, int fine, double sigma, const Effort& effort, Aligner& aligner,
                    MinimaWorkspace& workspace, Visit&& visit) const {
    const AlignProblem<Camera> part = part_of(problem, effort.points, workspace);
    auto& minima = workspace.tried;
    const auto follow = [&](int level) {
      minima.clear();
      for (const AlignState& start : workspace.starts) {
        const AlignState found = aligner.align(part, start, level, level).state;
        const bool known = std::any_of(minima.begin(), minima.end(), [&](const auto& other) {
          return is_near(part.points, problem.camera, found.T, other.second.T, kSamePixels);
        });
        if (!known && found.T.t.allFinite())
          minima.push_back({aligner.tukey_cost(problem, found, level, sigma), found});
      }
      keep_cheapest(minima, kFollowed);
      for (const auto& minimum : minima) visit(aligner.align(problem, minimum.second, level, fine));
    };
    const int coarse = level_of(std::min(problem.points.levels, problem.image.size()));
    if (coarse > fine) follow(coarse);
    follow(fine);  // a coarse level dominated by moving shadows leads away
  }

  /// The problem with roughly so many of its points, in workspace.part.
  template <typename Camera>
  static AlignProblem<Camera> part_of(const AlignProblem<Camera>& problem, int points, MinimaWorkspace& workspace) {
    workspace.part.take_every(std::max(1, problem.points.size() / points), problem.points);
    return {workspace.part, problem.image, problem.camera};
  }

  /// Whether the camera may make such a motion in addition to the expected one.
  bool reaches(const SE3d& T) const {
    return T.t.norm() <= 2 * metres + 0.1 && so3::log(T.R).norm() <= 2 * radians + 0.05;
  }

  /// The level on which shifts are searched. Their steps are a few pixels there.
  static int level_of(int levels) { return std::min(2, levels - 1); }

  static constexpr int kScanned = 250;  ///< points that compare many places, roughly

 private:
  using Places = std::vector<std::pair<double, AlignState>>;  ///< with their costs

  static constexpr int kSteps = 24;             ///< number of shifts to each side
  static constexpr std::size_t kMore = 4;       ///< shifts that all points compare, in addition to those that are kept
  static constexpr std::size_t kFollowed = 10;  ///< minima of a part of the points that are refined with all
  static constexpr double kSamePixels = 1;      ///< up to which two of these are the same
  static constexpr double kMostCostRatio = 2;   ///< largest cost of a place over that of the best one, after each round

  /// Adds shifts along each axis that fit better than their neighbours. Sideways they go up to half the depth, where
  /// little of the image is still in common. Along the optical axis far points stay visible, so they go twice as far.
  template <typename Camera, typename Aligner>
  void add_shifts(const AlignProblem<Camera>& problem, const AlignState& from, double depth, double sigma,
                  Aligner& aligner, Places& places) const {
    const int level = level_of(std::min(problem.points.levels, problem.image.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const double reach = std::min(metres, (axis == 2 ? 1 : 0.5) * depth);
      const auto place = [&](int i) {
        return from.at(SE3d::translation(Vector3<double>::Unit(axis) * reach * i / kSteps) * from.T);
      };
      find_minima(
          kSteps, [&](int i) { return aligner.tukey_cost(problem, place(i), level, sigma); },
          [&](double cost, int i) {
            places.push_back({cost, place(i)});
          });
    }
  }

  /// Moves a place to the best of several small rotations about one axis, then about the other, then to the best of
  /// several shifts.
  template <typename Camera, typename Aligner>
  void improve(const AlignProblem<Camera>& problem, double depth, double sigma, Aligner& aligner,
               Places::value_type& place) const {
    const int level = level_of(std::min(problem.points.levels, problem.image.size()));
    const double turn = 2 * (1 << level) / problem.camera.intrinsics().fx;
    const double shift = 0.5 * std::min(metres, depth) / kSteps;
    const auto take_best = [&](int n, auto&& step) {
      const AlignState from = place.second;
      for (int i = -n; i <= n; ++i) {
        const AlignState there = from.at(step(i) * from.T);
        const double cost = i == 0 ? place.first : aligner.tukey_cost(problem, there, level, sigma);
        if (cost < place.first) place = {cost, there};
      }
    };
    const auto turned = [](double x, double y) {
      return SE3d{so3::exp(Vector3<double>(x, y, 0)), Vector3<double>::Zero()};
    };
    take_best(2, [&](int i) { return turned(i * turn, 0); });
    take_best(2, [&](int i) { return turned(0, i * turn); });
    take_best(4, [&](int i) { return SE3d::translation(Vector3<double>(0, 0, i * shift)); });
  }
};

DOT_END_NAMESPACE
