// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/cell_votes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using dot::CellVotes;

constexpr int kWidth = 320, kHeight = 160;  // cells of 20 x 20 pixels

/// Points with the costs of two motions.
struct Costs {
  dot::PointSet points;
  std::vector<float> first, second;

  void add(int n, float u, float v, float cost_first, float cost_second) {
    for (int i = 0; i < n; ++i) {
      points.push(u, v, 0, 0, 0.1f, 0.01f);
      first.push_back(cost_first), second.push_back(cost_second);
    }
  }
  CellVotes votes() const {
    CellVotes v;
    v.add(points, first, second, kWidth, kHeight);
    return v;
  }
};

// A hundred points in a cell have one vote, like four.
TEST(CellVotes, CountAreaAndNotTexture) {
  Costs costs;
  costs.add(100, 10, 10, 0.1f, 3);
  costs.add(4, 110, 50, 3, 0.1f);
  costs.add(4, 210, 50, 3, 0.1f);
  const CellVotes votes = costs.votes();
  EXPECT_EQ(votes.first, 1);
  EXPECT_EQ(votes.second, 2);
  for (std::size_t i = 0; i < costs.first.size(); ++i)
    EXPECT_EQ(votes.second_q[CellVotes::cell_of(costs.points, i, kWidth, kHeight)] > 0, i >= 100) << i;
}

TEST(CellVotes, NeedAClearDifferenceAndEnoughPoints) {
  Costs costs;
  costs.add(10, 10, 10, 1, 1.1f);  // no texture: any motion fits
  costs.add(3, 110, 50, 0.1f, 3);
  EXPECT_EQ(costs.votes().first, 0);
  EXPECT_EQ(costs.votes().second, 0);
}

TEST(CellVotes, LeaveOutWhatOneMotionDoesNotSee) {
  Costs costs;
  costs.add(10, 10, 10, 0.1f, -1);
  costs.add(10, 110, 10, -1, 0.1f);
  EXPECT_EQ(costs.votes().first, 0);
  EXPECT_EQ(costs.votes().second, 0);
}

TEST(CellVotes, AddUpAndTakePointsAtTheBorder) {
  Costs costs;
  costs.add(4, kWidth - 1, kHeight - 1, 0.1f, 3);
  CellVotes v = costs.votes();
  v.add(costs.points, costs.first, costs.second, kWidth, kHeight);
  EXPECT_EQ(v.first, 2);
}

}  // namespace
