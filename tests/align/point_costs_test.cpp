// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#include "dot/align/point_costs.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "support/synthetic_scene.hpp"

namespace {

using dot::PointCosts;

/// Stands in for an aligner: the costs of the place whose number is the level.
struct Given {
  std::vector<std::vector<float>> costs;

  template <typename Problem>
  void point_costs(const Problem&, const dot::AlignState&, int place, double, std::vector<float>& out) const {
    out = costs[static_cast<std::size_t>(place)];
  }
};

void add(Given given, PointCosts& costs) {
  const dot::Pinhole camera(dot::test::small_camera());
  const dot::PointSet points;
  const dot::Pyramid image;
  const dot::AlignProblem<dot::Pinhole> problem{points, image, camera};
  for (std::size_t i = 0; i < given.costs.size(); ++i) costs.add(problem, {}, static_cast<int>(i), 1, given);
}
PointCosts costs_of(const Given& given) {
  PointCosts costs;
  add(given, costs);
  return costs;
}

/// `n` points of a cost, then `more` of another; negative: not seen.
std::vector<float> points(int n, float cost, int more = 0, float other = 0) {
  std::vector<float> all(static_cast<std::size_t>(n), cost);
  all.resize(all.size() + static_cast<std::size_t>(more), other);
  return all;
}

TEST(PointCosts, WhatOnlyOneSeesIsNoArgument) {
  // Ahead, 401 points are seen, at 1.1; standing still fits those at 1.6, and 600 of asphalt besides for nearly
  // nothing.
  const PointCosts costs = costs_of({{points(401, 1.6f, 600, 0.6f), points(401, 1.1f, 600, -1)}});
  EXPECT_NEAR(costs.ratio(0, 1), 1.6 / 1.1, 1e-5);
  EXPECT_NEAR(costs.ratio(1, 0), 1.1 / 1.6, 1e-5);
  EXPECT_EQ(costs.best(0), 1u);
}

TEST(PointCosts, WithoutSharedPointsEachCountsWhatItSees) {
  const PointCosts costs = costs_of({{points(30, 2, 50, -1), points(30, -1, 50, 1), points(80, -1)}});
  EXPECT_NEAR(costs.ratio(0, 1), 2, 1e-6);
  EXPECT_EQ(costs.best(0), 1u);
  EXPECT_TRUE(std::isinf(costs.ratio(2, 0)));
  EXPECT_EQ(costs.ratio(0, 2), 0);
}

// Two equal images leave no costs. A host may have the processor trap 0 / 0.
TEST(PointCosts, WithoutAnyCostAreEqual) {
  std::feclearexcept(FE_ALL_EXCEPT);
  const PointCosts costs = costs_of({{points(200, 0), points(200, 0), points(200, 1), points(30, 0), points(200, -1)}});
  EXPECT_EQ(costs.ratio(0, 1), 1);
  EXPECT_EQ(costs.ratio(3, 3), 1);
  EXPECT_EQ(costs.ratio(4, 4), 1);
  EXPECT_EQ(costs.ratio(0, 2), 0);
  EXPECT_TRUE(std::isinf(costs.ratio(2, 0)));
  EXPECT_EQ(costs.best(0), 0u);
  EXPECT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO), 0);
}

TEST(PointCosts, TheFirstOfEqualsIsTheBest) {
  PointCosts costs = costs_of({{points(200, 1.004f), points(200, 1), points(200, 1)}});
  EXPECT_EQ(costs.best(0.005), 0u);
  EXPECT_EQ(costs.best(0), 1u);
  costs.remove(1);
  EXPECT_EQ(costs.best(0), 2u);
  costs.remove(2);
  EXPECT_EQ(costs.best(0), 0u);
}

TEST(PointCosts, PlacesKeepTheirNumbers) {
  PointCosts costs = costs_of({{points(200, 2), points(200, 3)}});
  costs.remove(0);
  add({{points(200, 1)}}, costs);
  EXPECT_EQ(costs.best(0), 2u);
  costs.remove(2);
  EXPECT_EQ(costs.best(0), 1u);
  costs.clear();
  add({{points(200, 5)}}, costs);
  EXPECT_EQ(costs.best(0), 0u);
}

TEST(PointCosts, OneThatSeesNothingIsNeverTheBest) {
  EXPECT_EQ(costs_of({{points(200, -1), points(200, 3), points(200, -1)}}).best(0), 1u);
}

}  // namespace
