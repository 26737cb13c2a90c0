// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"

DOT_BEGIN_NAMESPACE

/// Finds starts for an unpredicted camera motion. A rotation moves the whole image, so it is searched first, on the
/// smallest images and with all points assumed to be infinitely far. Then shifts along each axis are tried, with and
/// without that rotation. Then both are refined alternately about the best, since near points shift the image as well.
struct CameraSearch {
  double metres = 0;      ///< largest expected translation of the camera
  double radians = 0;     ///< largest expected rotation of the camera
  const Pyramid& before;  ///< of the previous image
  SE3d T_before_j;        ///< pose of its camera from the points' frame

  /// Sets workspace.starts, poses T_i_j of the problem with the exposure change between the two images, and
  /// workspace.near, which are some pixels of level 0 from the minima that they lead to.
  /// @param depth of the points, metres; @param sigma grey values, scale of the residuals on level_of(...).
  template <typename Camera, typename Aligner>
  void find(const AlignProblem<Camera>& problem, double depth, double sigma, Aligner& aligner,
            MinimaWorkspace& workspace) const {
    find_turns(problem, aligner, workspace);
    find_shifts(problem, depth, sigma, aligner, workspace);
  }

  /// The same for other points, with the turns that `find` found.
  template <typename Camera, typename Aligner>
  void find_shifts(const AlignProblem<Camera>& problem, double depth, double sigma, Aligner& aligner,
                   MinimaWorkspace& workspace) const {
    auto& tried = workspace.tried;
    tried.clear();
    for (const auto& turn : workspace.turns) {
      const std::size_t others = tried.size();
      add_shifts(problem, moved(turn.second, turn.second.T * T_before_j), depth, sigma, aligner, tried);
      keep_cheapest(tried, kShifts, others);
    }
    workspace.starts.clear();
    workspace.near.clear();
    for (auto& place : tried) {
      workspace.starts.push_back(place.second);
      if (!improve(problem, depth, sigma, aligner, place)) continue;
      improve(problem, depth, sigma, aligner, place);
      workspace.near.push_back(place.second);
    }
  }

  /// Whether the camera may make such a motion in addition to the expected one.
  bool reaches(const SE3d& T) const {
    return T.t.norm() <= 2 * metres + 0.1 && so3::log(T.R).norm() <= 2 * radians + 0.05;
  }

  /// The level on which shifts are searched. Their steps are a few pixels there.
  static int level_of(int levels) { return std::min(2, levels - 1); }

 private:
  using Places = std::vector<std::pair<double, AlignState>>;  ///< with their costs

  static constexpr int kDistantPoints = 700;   ///< of the smallest image, roughly
  static constexpr std::size_t kAligned = 10;  ///< rotations of the grid that are refined
  static constexpr std::size_t kTurns = 4;     ///< rotations that are kept
  static constexpr std::size_t kShifts = 6;    ///< shifts that are kept for each rotation
  static constexpr int kSteps = 24;            ///< number of shifts to each side
  static constexpr double kAnotherTurn = 4;    ///< pixels of level 0 between two different rotations
  static constexpr double kInCommon = 0.5;     ///< least share of the past image inside the new one

  /// Gain and offset that give one image the mean and the standard deviation of another. An automatic exposure changes
  /// both more than objects that enter or leave the view.
  static AlignState exposure_between(const Image<std::uint8_t>& from, const Image<std::uint8_t>& to) {
    const auto moments = [](const Image<std::uint8_t>& image) {
      double sum = 0, squares = 0;
      for (int y = 0; y < image.height(); ++y)
        for (const std::uint8_t* grey = image.row(y); grey != image.row(y) + image.width(); ++grey)
          sum += *grey, squares += 1.0 * *grey * *grey;
      const double n = 1.0 * image.width() * image.height(), mean = sum / n;
      return std::pair{mean, std::sqrt(std::max(0.0, squares / n - mean * mean))};
    };
    const auto [mean_from, sigma_from] = moments(from);
    const auto [mean_to, sigma_to] = moments(to);
    const double gain = sigma_from > 0 ? sigma_to / sigma_from : 1;
    return {SE3d{}, gain, mean_to - gain * mean_from};
  }

  /// Sets workspace.turns to the rotations for which the past image correlates best with the new one, and to no
  /// rotation.
  template <typename Camera, typename Aligner>
  void find_turns(const AlignProblem<Camera>& problem, Aligner& aligner, MinimaWorkspace& workspace) const {
    Places& turns = workspace.turns;
    const AlignState unturned = exposure_between(before.levels.back(), problem.image.levels.back());
    turns.assign(1, {0, unturned});
    const int level = std::min(before.size(), problem.image.size()) - 1, finer = std::max(0, level - 1);
    take_distant(before, level, finer, problem.camera, workspace.distant);
    const AlignProblem<Camera> distant{workspace.distant, problem.image, problem.camera};
    const auto cost = [&](const SE3d& T, int l) { return -aligner.correlation(distant, T, l, kInCommon); };

    // Steps of a few pixels of that level, in the middle and at the sides. The aligner finds the minima between them.
    const double pixels = 1.5 * (1 << level), reach = std::min(radians, 0.2);
    const double side = std::max(pixels / problem.camera.intrinsics().fx, reach / 6);
    const double roll = std::max(pixels / (0.35 * problem.camera.width()), reach / 3);
    const int n = static_cast<int>(std::ceil(reach / side)), m = static_cast<int>(std::ceil(0.6 * reach / roll));
    Places& grid = workspace.tried;
    for (int z = -m; z <= m; ++z)
      for (int y = -n; y <= n; ++y)
        for (int x = -n; x <= n; ++x) {
          const SE3d T = turn_by({x * side, y * side, z * roll});
          grid.push_back({cost(T, level), moved(unturned, T)});
        }
    keep_cheapest(grid, kAligned);
    for (const auto& place : grid) {
      const SE3d T{aligner.align(distant, place.second, level, finer).state.T.R, Vector3<double>::Zero()};
      const bool known = std::any_of(turns.begin() + 1, turns.end(), [&](const auto& other) {
        return pose_distance(workspace.distant, problem.camera, T, other.second.T) < kAnotherTurn;
      });
      if (!known) turns.push_back({cost(T, finer), moved(unturned, T)});
    }
    keep_cheapest(turns, kTurns, 1);
    grid.clear();
  }

  /// Takes points at infinity all over an image, with their intensities on two levels.
  template <typename Camera>
  static void take_distant(const Pyramid& image, int level, int finer, const Camera& camera, PointSet& points) {
    points.clear();
    points.levels = level + 1;
    const Image<std::uint8_t>& smallest = image.levels[static_cast<std::size_t>(level)];
    const int area = smallest.width() * smallest.height();
    const int step = std::max(1, static_cast<int>(std::lround(std::sqrt(1.0 * area / kDistantPoints))));
    const Camera scaled = camera.at_level(level);
    for (int y = 2; y < smallest.height() - 2; y += step)
      for (int x = 2; x < smallest.width() - 2; x += step) {
        const Vector3<double> ray = scaled.template unproject<double>(Vector2<double>(x, y));
        const float scale = static_cast<float>(1 << level);
        points.push(scale * (static_cast<float>(x) + 0.5f) - 0.5f, scale * (static_cast<float>(y) + 0.5f) - 0.5f,
                    static_cast<float>(ray.x()), static_cast<float>(ray.y()), 0, 0);
        for (int l = finer; l <= level; ++l) {
          const auto at = static_cast<std::size_t>(l);
          const float s = 1.f / static_cast<float>(1 << l);
          const Sample here =
              sample(image.levels[at], s * (points.u.back() + 0.5f) - 0.5f, s * (points.v.back() + 0.5f) - 0.5f);
          points.intensity[at].push_back(here.value);
          points.gu[at].push_back(here.gx);
          points.gv[at].push_back(here.gy);
        }
      }
  }

  /// The same exposure at another pose.
  static AlignState moved(const AlignState& from, const SE3d& T) { return {T, from.gain, from.offset}; }
  static SE3d turn_by(const Vector3<double>& w) { return {so3::exp(w), Vector3<double>::Zero()}; }

  /// Adds shifts along each axis that fit better than their neighbours. Sideways they go up to half the depth, where
  /// little of the image is still in common. Along the optical axis far points stay visible, so they go twice as far.
  template <typename Camera, typename Aligner>
  void add_shifts(const AlignProblem<Camera>& problem, const AlignState& from, double depth, double sigma,
                  Aligner& aligner, Places& places) const {
    const int level = level_of(std::min(problem.points.levels, problem.image.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const double reach = std::min(metres, (axis == 2 ? 1 : 0.5) * depth);
      const auto place = [&](int i) {
        return moved(from, SE3d::translation(Vector3<double>::Unit(axis) * reach * i / kSteps) * from.T);
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
  /// @return whether one was better.
  template <typename Camera, typename Aligner>
  bool improve(const AlignProblem<Camera>& problem, double depth, double sigma, Aligner& aligner,
               Places::value_type& place) const {
    const int level = level_of(std::min(problem.points.levels, problem.image.size()));
    const double turn = 2 * (1 << level) / problem.camera.intrinsics().fx;
    const double shift = 0.5 * std::min(metres, depth) / kSteps;
    const double cost_before = place.first;
    const auto take_best = [&](int n, auto&& step) {
      const AlignState from = place.second;
      for (int i = -n; i <= n; ++i) {
        const AlignState there = moved(from, step(i) * from.T);
        const double cost = i == 0 ? place.first : aligner.tukey_cost(problem, there, level, sigma);
        if (cost < place.first) place = {cost, there};
      }
    };
    take_best(2, [&](int i) { return turn_by({i * turn, 0, 0}); });
    take_best(2, [&](int i) { return turn_by({0, i * turn, 0}); });
    take_best(4, [&](int i) { return SE3d::translation(Vector3<double>(0, 0, i * shift)); });
    return place.first < cost_before;
  }
};

DOT_END_NAMESPACE
