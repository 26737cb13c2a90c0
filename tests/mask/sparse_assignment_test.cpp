// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/sparse_assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<int> sparse(const std::vector<dot::PossiblePair>& pairs, int rows, int columns, double absent) {
  dot::SparseAssignWorkspace workspace;
  workspace.pairs = pairs;
  return dot::assign(rows, columns, absent, workspace);
}

/// Sum over the pairs made of what they save against `absent`, or, where that is infinite, 1000 for each pair less its
/// cost.
double value(const std::vector<dot::PossiblePair>& pairs, const std::vector<int>& partner, double absent) {
  double sum = 0;
  std::set<int> used;
  for (std::size_t row = 0; row < partner.size(); ++row) {
    if (partner[row] < 0) continue;
    EXPECT_TRUE(used.insert(partner[row]).second) << "column " << partner[row] << " twice";
    const auto p = std::find_if(pairs.begin(), pairs.end(), [&](const dot::PossiblePair& pair) {
      return pair.row == static_cast<int>(row) && pair.column == partner[row];
    });
    if (p == pairs.end()) {
      ADD_FAILURE() << "row " << row << " has column " << partner[row] << ", which is not possible";
      continue;
    }
    sum += (std::isfinite(absent) ? absent : 1000) - p->cost;
  }
  return sum;
}

/// The same answer as one dense problem gives.
void compare_with_dense(double absent) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> size(1, 12);
  std::uniform_real_distribution<double> draw(0, 1);
  std::bernoulli_distribution possible(0.15);
  int groups_of_several = 0;
  for (int round = 0; round < 300; ++round) {
    const int rows = size(random), columns = size(random);
    std::vector<dot::PossiblePair> pairs;
    std::vector<double> cost(static_cast<std::size_t>(rows * columns), absent);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j)
        if (possible(random)) {
          pairs.push_back({i, j, draw(random)});
          cost[static_cast<std::size_t>(i * columns + j)] = pairs.back().cost;
        }
    std::shuffle(pairs.begin(), pairs.end(), random);
    dot::AssignWorkspace dense;
    std::vector<int> expected = dot::assign(cost, rows, columns, dense);
    for (int i = 0; i < rows; ++i) {
      int& j = expected[static_cast<std::size_t>(i)];
      const bool exists =
          std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) { return p.row == i && p.column == j; });
      if (!exists) j = -1;
    }
    const std::vector<int> found = sparse(pairs, rows, columns, absent);
    EXPECT_NEAR(value(pairs, found, absent), value(pairs, expected, absent), 1e-9) << rows << 'x' << columns;
    groups_of_several += pairs.size() > 3;
  }
  EXPECT_GT(groups_of_several, 100);
}

TEST(SparseAssignment, EqualsTheDenseOneWhereNoPartnerCosts) { compare_with_dense(1); }
TEST(SparseAssignment, EqualsTheDenseOneWhereOthersAreForbidden) { compare_with_dense(kNever); }

TEST(SparseAssignment, MakesNoPairWithoutPairs) {
  EXPECT_TRUE(sparse({}, 0, 0, 1).empty());
  EXPECT_EQ(sparse({}, 2, 3, 1), (std::vector<int>{-1, -1}));
  EXPECT_EQ(sparse({{1, 2, 0.5}}, 2, 3, kNever), (std::vector<int>{-1, 2}));
}

TEST(SparseAssignment, SolvesManySmallGroups) {
  constexpr int n = 20000;  // one dense problem of them would take 3 GB
  std::vector<dot::PossiblePair> pairs;
  for (int i = 0; i < n; i += 2)
    for (const auto& [row, column, cost] : {std::tuple{0, 0, 0.1}, {0, 1, 0.2}, {1, 0, 0.2}, {1, 1, 0.9}})
      pairs.push_back({i + row, i + column, cost});
  const std::vector<int> found = sparse(pairs, n, n, 1);
  for (int i = 0; i < n; i += 2) {
    ASSERT_EQ(found[static_cast<std::size_t>(i)], i + 1);
    ASSERT_EQ(found[static_cast<std::size_t>(i) + 1], i);
  }
}

}  // namespace
