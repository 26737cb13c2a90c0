// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/kernel/lanes.hpp"

DOT_BEGIN_NAMESPACE

/// Costs of places (poses), point by point. Two places are compared by the points that both see. If the means over the
/// points that each sees were compared, a place could be better only because it keeps points with small residuals in
/// view. Such points are on near asphalt, which leaves the image when the camera moves ahead.
class PointCosts {
 public:
  /// Removes all places. Keeps the memory.
  void clear() {
    open_.clear();
    count_ = 0;
  }

  /// Adds a place, with the Tukey costs of a level at a given sigma_I.
  template <typename Camera, typename Aligner>
  void add(const AlignProblem<Camera>& problem, const AlignState& state, int level, double sigma, Aligner& aligner) {
    const std::size_t place = count_++;
    if (place == costs_.size()) costs_.emplace_back();
    aligner.point_costs(problem, state, level, sigma, costs_[place]);
    open_.push_back(place);
  }

  /// The costs of a place's points. Places count from 0 in the order of `add`. A point that is not seen has a negative
  /// cost.
  const std::vector<float>& of(std::size_t place) const { return costs_[place]; }

  /// Cost of a place over that of another: of the points that both see or, if these are too few, of those that each
  /// sees. 1 where both are zero, as between two equal images.
  double ratio(std::size_t place, std::size_t other) const {
    const Sum shared = sum(place, other);
    const bool enough = shared.count >= kShared;
    const double cost = enough ? static_cast<double>(shared.cost) : sum(place, place).mean();
    const double by = enough ? static_cast<double>(sum(other, place).cost) : sum(other, other).mean();
    if (cost == by) return 1;  // also 0 / 0, which a host may trap
    return by > 0 ? cost / by : std::numeric_limits<double>::infinity();
  }

  /// The place, of those not removed, that no other place beats by this share of the cost, if there is one. Earlier
  /// places are preferred. @pre At least one place is not removed.
  std::size_t best(double share) const {
    return best(share, [](std::size_t) { return 1.0; });
  }
  /// The same with the costs multiplied by factor(place).
  template <typename Factor>
  std::size_t best(double share, Factor&& factor) const {
    std::size_t chosen = open_.front();
    for (int pass = 0; pass < 2; ++pass)
      for (const std::size_t place : open_)
        if (place != chosen && factor(place) * ratio(place, chosen) < (1 - share) * factor(chosen)) chosen = place;
    return chosen;
  }

  /// Takes a place out of `best`.
  void remove(std::size_t place) { open_.erase(std::find(open_.begin(), open_.end(), place)); }

 private:
  static constexpr int kShared = 100;  ///< points that are enough for a comparison

  struct Sum {
    int count = 0;
    float cost = 0;
    double mean() const { return count ? static_cast<double>(cost) / count : std::numeric_limits<double>::infinity(); }
  };

  /// Sum of a place's costs over the points that the other place sees, too.
  Sum sum(std::size_t place, std::size_t other) const {
    using Lanes = PortableLanes;
    constexpr std::size_t W = Lanes::W;
    const std::vector<float>&a = costs_[place], &b = costs_[other];
    const Lanes::F zero = Lanes::set(0);
    Lanes::F cost = zero;
    Sum sum;
    std::size_t i = 0;
    for (; i + W <= a.size(); i += W) {
      const Lanes::F here = Lanes::load(a.data() + i);
      const Lanes::M both = Lanes::both(Lanes::not_less(here, zero), Lanes::not_less(Lanes::load(b.data() + i), zero));
      cost = Lanes::add(cost, Lanes::keep(both, here));
      sum.count += Lanes::count(both);
    }
    sum.cost = Lanes::sum(cost);
    for (; i < a.size(); ++i)
      if (a[i] >= 0 && b[i] >= 0) ++sum.count, sum.cost += a[i];
    return sum;
  }

  std::vector<std::vector<float>> costs_;  ///< of each place and point, negative if it is not seen
  std::size_t count_ = 0;                  ///< of places; further elements only keep their memory
  std::vector<std::size_t> open_;          ///< places that were not removed
};

DOT_END_NAMESPACE
