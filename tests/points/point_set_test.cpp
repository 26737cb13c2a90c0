// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/point_set.hpp"

#include <gtest/gtest.h>

namespace {

using dot::PointSet;

/// Point i has u = i, v = 10 i, ..., and on level l an intensity of 100 l + i. They have no gradients.
PointSet numbered(int count) {
  PointSet points;
  points.levels = 2;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<float>(i);
    points.push(n, 10 * n, 20 * n, 30 * n, 40 * n, 50 * n);
    for (std::size_t l = 0; l < 2; ++l) points.intensity[l].push_back(100 * static_cast<float>(l) + n);
  }
  return points;
}

TEST(PointSet, TakesEveryThirdWithAllThatBelongsToIt) {
  PointSet few = numbered(30);  // to be replaced
  few.take_every(3, numbered(8));
  ASSERT_EQ(few.size(), 3);
  EXPECT_EQ(few.levels, 2);
  EXPECT_EQ(few.u, (std::vector<float>{0, 3, 6}));
  EXPECT_EQ(few.v, (std::vector<float>{0, 30, 60}));
  EXPECT_EQ(few.x, (std::vector<float>{0, 60, 120}));
  EXPECT_EQ(few.y, (std::vector<float>{0, 90, 180}));
  EXPECT_EQ(few.q, (std::vector<float>{0, 120, 240}));
  EXPECT_EQ(few.sigma_q, (std::vector<float>{0, 150, 300}));
  EXPECT_EQ(few.intensity[0], (std::vector<float>{0, 3, 6}));
  EXPECT_EQ(few.intensity[1], (std::vector<float>{100, 103, 106}));
  EXPECT_TRUE(few.gu[0].empty());
}

TEST(PointSet, TakesAllOrNone) {
  PointSet few;
  few.take_every(1, numbered(5));
  EXPECT_EQ(few.u, numbered(5).u);
  few.take_every(4, PointSet{});
  EXPECT_EQ(few.size(), 0);
}

TEST(PointSet, TakesThoseThatMeetACondition) {
  PointSet some = numbered(30);  // to be replaced
  some.take_if(numbered(8), [](std::size_t i) { return i == 1 || i == 6; });
  EXPECT_EQ(some.u, (std::vector<float>{1, 6}));
  EXPECT_EQ(some.sigma_q, (std::vector<float>{50, 300}));
  EXPECT_EQ(some.intensity[1], (std::vector<float>{101, 106}));
  EXPECT_EQ(some.levels, 2);
}

TEST(PointSet, AppendsOthersWithTheLevelsThatBothHave) {
  PointSet all = numbered(2), others = numbered(5);
  others.levels = 1;
  others.bias.coefficients[0] = 0.5;
  all.append_every(2, others);
  EXPECT_EQ(all.u, (std::vector<float>{0, 1, 0, 2, 4}));
  EXPECT_EQ(all.intensity[0], (std::vector<float>{0, 1, 0, 2, 4}));
  EXPECT_EQ(all.levels, 1);
  EXPECT_TRUE(all.bias.is_zero());
  PointSet none;
  none.append_every(1, numbered(3));
  EXPECT_EQ(none.levels, 2);
  EXPECT_EQ(none.size(), 3);
}

// Of a bias that becomes known bit by bit, each point loses what the last one says at its place.
TEST(PointSet, TakesWhatBecomesKnownOfABias) {
  PointSet points;
  points.push(0, 0, 0, 0, 0.5f, 0);
  points.push(100, 50, 0, 0, 0.5f, 0);
  points.push(150, 50, 0, 0, 0.02f, 0);
  dot::DepthBias first, second;
  first.coefficients[1] = 0.1;  // -0.1 at the left border, 0 in the middle, 0.05 between that and the right one
  EXPECT_TRUE(points.subtract_bias(first, 200, 100));
  EXPECT_NEAR(points.q[0], 0.6, 1e-6);
  EXPECT_NEAR(points.q[1], 0.5, 1e-6);
  EXPECT_GT(points.q[2], 0);  // as far as can be, but seen
  EXPECT_FALSE(points.subtract_bias(first, 200, 100));
  second.coefficients[1] = 0.1, second.coefficients[5] = 0.2;
  EXPECT_TRUE(points.subtract_bias(second, 200, 100));
  EXPECT_NEAR(points.q[0], 0.8, 1e-6);
  EXPECT_NEAR(points.q[1], 0.5, 1e-6);
  EXPECT_EQ(points.bias.coefficients, second.coefficients);
  points.clear();
  EXPECT_TRUE(points.bias.is_zero());
}

}  // namespace
