// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

#include "dot/align/minima.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace {

using dot::find_minima;
using dot::keep_cheapest;
using dot::keep_comparable;

using Pairs = std::vector<std::pair<double, char>>;

std::string letters(const Pairs& pairs) {
  std::string all;
  for (const auto& pair : pairs) all += pair.second;
  return all;
}

TEST(KeepCheapest, KeepsThemInOrder) {
  Pairs pairs{{3, 'c'}, {1, 'a'}, {4, 'd'}, {2, 'b'}};
  keep_cheapest(pairs, 3);
  EXPECT_EQ(letters(pairs), "abc");
  keep_cheapest(pairs, 5);
  EXPECT_EQ(letters(pairs), "abc");
}

TEST(KeepCheapest, LeavesWhatIsBefore) {
  Pairs pairs{{9, 'z'}, {8, 'y'}, {3, 'c'}, {1, 'a'}, {2, 'b'}};
  keep_cheapest(pairs, 2, 2);
  EXPECT_EQ(letters(pairs), "zyab");
  keep_cheapest(pairs, 2, 4);
  EXPECT_EQ(letters(pairs), "zyab");
}

TEST(KeepComparable, DropsWhatCostsMuchMore) {
  Pairs pairs{{2.1, 'c'}, {1, 'a'}, {4, 'd'}, {2, 'b'}};
  keep_comparable(pairs, 2);
  EXPECT_EQ(letters(pairs), "ab");
  keep_comparable(pairs, 1.5);
  EXPECT_EQ(letters(pairs), "a");
}

TEST(KeepComparable, NoCostIsMuchMoreWhereAllAreNegligible) {
  Pairs pairs{{0.06, 'c'}, {0.04, 'b'}, {0, 'a'}};
  keep_comparable(pairs, 2);
  EXPECT_EQ(letters(pairs), "ab");
}

TEST(KeepComparable, NothingSeenAnywhere) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  Pairs pairs{{beyond, 'a'}, {beyond, 'b'}};
  keep_comparable(pairs, 2);
  EXPECT_EQ(letters(pairs), "ab");
  Pairs none;
  keep_comparable(none, 2);
  EXPECT_EQ(letters(none), "");
}

/// Where minima of a cost given for -n..n are found.
std::vector<int> minima_of(const std::vector<double>& costs) {
  const int n = static_cast<int>(costs.size()) / 2;
  std::vector<int> found;
  find_minima(
      n, [&](int i) { return costs.at(static_cast<std::size_t>(i + n)); },
      [&](double cost, int i) {
        EXPECT_EQ(cost, costs.at(static_cast<std::size_t>(i + n)));
        found.push_back(i);
      });
  return found;
}

TEST(FindMinima, InsideAndAtTheEnds) {
  EXPECT_EQ(minima_of({1, 2, 0, 3, 2}), (std::vector<int>{-2, 0, 2}));
  EXPECT_EQ(minima_of({3, 2, 1}), (std::vector<int>{1}));
  EXPECT_EQ(minima_of({5}), (std::vector<int>{0}));
}

TEST(FindMinima, NotWhereNothingIsSeen) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  EXPECT_EQ(minima_of({beyond, 2, beyond, beyond, beyond}), (std::vector<int>{-1}));
  EXPECT_EQ(minima_of({beyond, beyond, beyond}), (std::vector<int>{}));
}

}  // namespace
