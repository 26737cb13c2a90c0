// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/hungarian.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

std::vector<int> assign(const std::vector<double>& cost, int rows, int cols) {
  dot::AssignWorkspace workspace;
  return dot::assign(cost, rows, cols, workspace);
}

struct Value {
  int pairs = 0;
  double cost = 0;
  bool better_than(const Value& other) const {
    return pairs > other.pairs || (pairs == other.pairs && cost < other.cost);
  }
};

/// The best set of pairs, found by trying them all.
Value brute_force(const std::vector<double>& cost, int rows, int cols, int row, std::vector<char>& taken) {
  if (row == rows) return {};
  Value best = brute_force(cost, rows, cols, row + 1, taken);
  for (int j = 0; j < cols; ++j) {
    const double c = cost[static_cast<std::size_t>(row * cols + j)];
    if (taken[static_cast<std::size_t>(j)] || !std::isfinite(c)) continue;
    taken[static_cast<std::size_t>(j)] = 1;
    Value value = brute_force(cost, rows, cols, row + 1, taken);
    taken[static_cast<std::size_t>(j)] = 0;
    ++value.pairs;
    value.cost += c;
    if (value.better_than(best)) best = value;
  }
  return best;
}

/// The value of an assignment; checks that it is one.
Value value_of(const std::vector<int>& column, const std::vector<double>& cost, int rows, int cols) {
  EXPECT_EQ(column.size(), static_cast<std::size_t>(rows));
  Value value;
  std::set<int> used;
  for (int i = 0; i < rows; ++i) {
    const int j = column[static_cast<std::size_t>(i)];
    if (j < 0) continue;
    EXPECT_LT(j, cols);
    EXPECT_TRUE(used.insert(j).second) << "column " << j << " twice";
    const double c = cost[static_cast<std::size_t>(i * cols + j)];
    EXPECT_TRUE(std::isfinite(c)) << "forbidden pair " << i << ' ' << j;
    ++value.pairs;
    value.cost += c;
  }
  return value;
}

void compare_with_brute_force(double low, double high, double forbidden_share, bool whole_numbers) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> size(1, 6);
  std::uniform_real_distribution<double> draw(low, high);
  std::bernoulli_distribution forbid(forbidden_share);
  for (int round = 0; round < 300; ++round) {
    const int rows = size(random), cols = size(random);
    std::vector<double> cost(static_cast<std::size_t>(rows * cols));
    for (double& c : cost) c = forbid(random) ? kForbidden : whole_numbers ? std::round(draw(random)) : draw(random);
    std::vector<char> taken(static_cast<std::size_t>(cols), 0);
    const Value expected = brute_force(cost, rows, cols, 0, taken);
    const Value found = value_of(assign(cost, rows, cols), cost, rows, cols);
    EXPECT_EQ(found.pairs, expected.pairs) << rows << 'x' << cols;
    EXPECT_NEAR(found.cost, expected.cost, 1e-9 * std::max(std::abs(low), std::abs(high))) << rows << 'x' << cols;
  }
}

TEST(Hungarian, EqualsBruteForce) { compare_with_brute_force(0, 1, 0, false); }
TEST(Hungarian, EqualsBruteForceWithForbiddenPairs) { compare_with_brute_force(0, 1, 0.5, false); }
TEST(Hungarian, EqualsBruteForceWithFewAllowedPairs) { compare_with_brute_force(0, 1, 0.85, false); }
TEST(Hungarian, EqualsBruteForceWithNegativeCosts) { compare_with_brute_force(-50, 20, 0.3, false); }
TEST(Hungarian, EqualsBruteForceWithTies) { compare_with_brute_force(0, 3, 0.3, true); }
TEST(Hungarian, EqualsBruteForceWithLargeCosts) { compare_with_brute_force(1e8, 2e8, 0.3, false); }

TEST(Hungarian, TakesTheDetourThatGreedyMisses) {
  const std::vector<double> cost{1, 2,  //
                                 2, 100};
  EXPECT_EQ(assign(cost, 2, 2), (std::vector<int>{1, 0}));
}

TEST(Hungarian, HandlesWhatIsEmptyOrForbidden) {
  EXPECT_TRUE(assign({}, 0, 0).empty());
  EXPECT_TRUE(assign({}, 0, 4).empty());
  EXPECT_EQ(assign({}, 3, 0), (std::vector<int>{-1, -1, -1}));
  EXPECT_EQ(assign(std::vector<double>(6, kForbidden), 2, 3), (std::vector<int>{-1, -1}));
  EXPECT_EQ(assign({kForbidden, std::nan(""), 7, kForbidden}, 2, 2), (std::vector<int>{-1, 0}));
}

TEST(Hungarian, SolvesLargeProblems) {
  // A hidden permutation of cost 0 among positive costs is the only optimum.
  constexpr int n = 120;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> draw(0.01, 1);
  std::vector<int> hidden(n);
  for (int i = 0; i < n; ++i) hidden[static_cast<std::size_t>(i)] = i;
  std::shuffle(hidden.begin(), hidden.end(), random);
  std::vector<double> cost(n * n);
  for (double& c : cost) c = draw(random);
  for (std::size_t i = 0; i < n; ++i) cost[i * n + static_cast<std::size_t>(hidden[i])] = 0;
  EXPECT_EQ(assign(cost, n, n), hidden);
}

TEST(Hungarian, RefusesAWrongSize) {
  EXPECT_THROW(assign({1, 2, 3}, 2, 2), std::invalid_argument);
  EXPECT_THROW(assign({1, 2}, -1, -2), std::invalid_argument);
}

}  // namespace
