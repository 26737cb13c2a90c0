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

DOT_BEGIN_NAMESPACE

/// Finds rotations of the camera from one image to another. A rotation moves the whole image, so the past image is
/// correlated with the new one on the smallest images, with all points assumed to be infinitely far.
struct TurnSearch {
  double radians = 0;     ///< largest expected rotation of the camera
  const Pyramid& before;  ///< of the previous image

  /// Sets workspace.turns to the rotations for which the images correlate best, and to no rotation, first. All have the
  /// exposure change between the two images.
  template <typename Camera, typename Aligner>
  void find(const Pyramid& image, const Camera& camera, Aligner& aligner, MinimaWorkspace& workspace) const {
    Places& turns = workspace.turns;
    const AlignState unturned = exposure_between(before.levels.back(), image.levels.back());
    turns.assign(1, {0, unturned});
    const int level = std::min(before.size(), image.size()) - 1, finer = std::max(0, level - 1);
    take_distant(before, level, finer, camera, workspace.distant);
    AlignProblem<Camera> distant{workspace.distant, image, camera};
    workspace.quads.copy_level(image, level);
    distant.quads = &workspace.quads;
    const auto cost = [&](const SE3d& T, int l) { return -aligner.correlation(distant, T, l, kInCommon); };

    // Steps of a few pixels of that level, in the middle and at the sides. The aligner finds the minima between them.
    const double pixels = 1.5 * (1 << level), reach = std::min(radians, 0.2);
    const double side = std::max(pixels / camera.intrinsics().fx, reach / 6);
    const double roll = std::max(pixels / (0.35 * camera.width()), reach / 3);
    const int n = static_cast<int>(std::ceil(reach / side)), m = static_cast<int>(std::ceil(0.6 * reach / roll));
    Places& grid = workspace.tried;
    grid.clear();
    for (int z = -m; z <= m; ++z)
      for (int y = -n; y <= n; ++y)
        for (int x = -n; x <= n; ++x) {
          const SE3d T{so3::exp(Vector3<double>(x * side, y * side, z * roll)), Vector3<double>::Zero()};
          grid.push_back({cost(T, level), unturned.at(T)});
        }
    keep_cheapest(grid, kAligned);
    for (const auto& place : grid) {
      const SE3d T{aligner.align(distant, place.second, level, finer).state.T.R, Vector3<double>::Zero()};
      const bool known = std::any_of(turns.begin() + 1, turns.end(), [&](const auto& other) {
        return is_near(workspace.distant, camera, T, other.second.T, kAnotherTurn);
      });
      if (!known) turns.push_back({cost(T, finer), unturned.at(T)});
    }
    keep_cheapest(turns, kTurns, 1);
  }

 private:
  using Places = std::vector<std::pair<double, AlignState>>;  ///< with their costs

  static constexpr int kDistantPoints = 700;   ///< of the smallest image, roughly
  static constexpr std::size_t kAligned = 10;  ///< rotations of the grid that are refined
  static constexpr std::size_t kTurns = 4;     ///< rotations that are kept
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
};

DOT_END_NAMESPACE
