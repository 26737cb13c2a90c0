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
#include "dot/align/point_costs.hpp"
#include "dot/align/pose_distance.hpp"

DOT_BEGIN_NAMESPACE

/// Keeps the `count` cheapest of the pairs (cost, value) from index `begin` on, sorted by cost. Those before `begin`
/// are kept, too.
template <typename Pairs>
void keep_cheapest(Pairs& pairs, std::size_t count, std::size_t begin = 0) {
  const auto from = pairs.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto kept = from + static_cast<std::ptrdiff_t>(std::min(count, pairs.size() - begin));
  std::partial_sort(from, kept, pairs.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
  pairs.erase(kept, pairs.end());
}

/// Tukey cost of a point in a perfect image, at most. It is no worse than any lower one; an inlier's is 0.45.
inline constexpr double kNegligibleCost = 0.05;

/// Keeps the pairs (cost, value) whose cost is at most `ratio` times the lowest one, or negligible, sorted by cost.
template <typename Pairs>
void keep_comparable(Pairs& pairs, double ratio) {
  keep_cheapest(pairs, pairs.size());
  const auto costs_more = [&](const auto& pair) {
    return pair.first > std::max(kNegligibleCost, ratio * pairs.front().first);
  };
  pairs.erase(std::find_if(pairs.begin(), pairs.end(), costs_more), pairs.end());
}

/// Calls `found(cost, i)` for each i in [-n, n] whose cost(i) is finite and no higher than that of its neighbours.
template <typename Cost, typename Found>
void find_minima(int n, Cost&& cost, Found&& found) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  double before = beyond, here = cost(-n);
  for (int i = -n; i <= n; ++i) {
    const double after = i < n ? cost(i + 1) : beyond;
    if (std::isfinite(here) && here <= before && here <= after) found(here, i);
    before = here, here = after;
  }
}

/// Local minima found from several starts.
struct Minima {
  static constexpr double kSamePixels = 0.1;  ///< distance of the points in the image up to which two minima are one
  std::vector<Alignment> found;               ///< in the order of their finding

  /// Drops the minima for which `condition` holds, unless it holds for all.
  template <typename Condition>
  void drop_if(Condition&& condition) {
    if (!std::all_of(found.begin(), found.end(), condition))
      found.erase(std::remove_if(found.begin(), found.end(), condition), found.end());
  }
  /// @param same_pixels distance up to which it counts as one with another minimum.
  /// @return whether it was a new minimum.
  template <typename Camera>
  bool add(const AlignProblem<Camera>& problem, const Alignment& a, double same_pixels = kSamePixels) {
    for (const Alignment& other : found)
      if (is_near(problem.points, problem.camera, a.state.T, other.state.T, same_pixels)) return false;
    found.push_back(a);
    return true;
  }
};

/// Buffers of the estimators that search for such minima.
struct MinimaWorkspace {
  Minima minima;                                       ///< found so far
  std::vector<AlignState> starts;                      ///< places to align from
  std::vector<std::pair<double, AlignState>> tried;    ///< with their costs
  std::vector<std::pair<double, AlignState>> turns;    ///< rotations that fit distant points, with their costs
  PointCosts costs;                                    ///< of the places in comparison
  std::vector<std::pair<double, std::size_t>> ranked;  ///< costs of the minima
  std::vector<Alignment> kept;                         ///< minima that the motion is chosen among
  std::vector<float> depths;                           ///< of the points, to sort them
  Quads quads;                                         ///< of the level on which many places are compared
  PointSet few;                                        ///< a part of the points, to rank many places
  PointSet part;                                       ///< a part of these, to rank more places
  PointSet distant;                                    ///< points at infinity
  PointSet unexplained;                                ///< the points that another motion does not explain
  std::vector<float> point_costs;                      ///< of each point at one place
  std::vector<float> other_costs;                      ///< of each point at another place
};

DOT_END_NAMESPACE
