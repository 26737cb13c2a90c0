// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/statistics/median.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "support/random.hpp"

namespace {

std::vector<float> shuffled(int n, unsigned seed) {
  dot::test::Random random(seed);
  std::vector<float> v;
  for (int i = 0; i < n; ++i) v.push_back(static_cast<float>(random.uniform()));
  return v;
}

TEST(Median, IsTheMiddleOneOrOneOfTwo) {
  std::vector<int> odd{5, 1, 3}, even{4, 1, 3, 2}, one{7};
  EXPECT_EQ(dot::median(odd.begin(), odd.end()), 3);
  EXPECT_EQ(dot::lower_median(odd.begin(), odd.end()), 3);
  EXPECT_EQ(dot::median(even.begin(), even.end()), 3);
  EXPECT_EQ(dot::lower_median(even.begin(), even.end()), 2);
  EXPECT_EQ(dot::median(one.begin(), one.end()), 7);
  EXPECT_EQ(dot::lower_median(one.begin(), one.end()), 7);
}

TEST(Quantile, GoesFromTheSmallestToTheLargest) {
  for (int n = 1; n < 30; ++n) {
    std::vector<float> v = shuffled(n, 1), sorted = v;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(dot::quantile(v.begin(), v.end(), 0), sorted.front());
    EXPECT_EQ(dot::quantile(v.begin(), v.end(), 1), sorted.back());
    EXPECT_EQ(dot::quantile(v.begin(), v.end(), 0.3), sorted[static_cast<std::size_t>(0.3 * (n - 1))]);
  }
}

TEST(Spread, IsThreeQuantilesAndLeavesTheLowerHalfFirst) {
  for (int n = 1; n < 60; ++n) {
    std::vector<float> v = shuffled(n, 2), copy = v;
    const auto s = dot::spread(v.begin(), v.end());
    EXPECT_EQ(s.low, dot::quantile(copy.begin(), copy.end(), 0.2)) << n;
    EXPECT_EQ(s.middle, dot::quantile(copy.begin(), copy.end(), 0.5)) << n;
    EXPECT_EQ(s.high, dot::quantile(copy.begin(), copy.end(), 0.8)) << n;
    const auto middle = v.begin() + (n - 1) / 2;
    EXPECT_TRUE(std::all_of(v.begin(), middle, [&](float q) { return q <= s.middle; })) << n;
    EXPECT_TRUE(std::all_of(middle, v.end(), [&](float q) { return q >= s.middle; })) << n;
  }
}

/// Values of one kind: 0 all different, 1 a few, often repeated, 2 all equal, 3 rising, 4 falling, 5 of which the
/// sample for a pivot takes only the largest.
std::vector<float> values_of(int kind, int n, unsigned seed) {
  std::vector<float> v = shuffled(n, seed);
  for (int i = 0; i < n; ++i) {
    float& each = v[static_cast<std::size_t>(i)];
    if (kind == 1) each = std::floor(5 * each);
    if (kind == 2) each = 3;
    if (kind == 5 && i % std::max(1, n / 15) == 0) each += 10;
  }
  if (kind == 3) std::sort(v.begin(), v.end());
  if (kind == 4) std::sort(v.begin(), v.end(), std::greater<>());
  return v;
}

TEST(SortNth, GivesTheNthOfAllAndSplitsTheOthers) {
  for (const int n : {1, 2, 64, 65, 100, 333, 2000})
    for (int kind = 0; kind < 6; ++kind) {
      const std::vector<float> values = values_of(kind, n, 4);
      std::vector<float> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      for (const double share : {0.0, 0.01, 0.2, 0.5, 0.6, 0.95, 1.0}) {
        std::vector<float> v = values;
        const auto nth = v.begin() + static_cast<std::ptrdiff_t>(share * (n - 1));
        dot::sort_nth(v.begin(), nth, v.end());
        const float found = *nth;
        EXPECT_EQ(found, sorted[static_cast<std::size_t>(nth - v.begin())]) << n << " " << kind << " " << share;
        EXPECT_TRUE(std::all_of(v.begin(), nth, [&](float q) { return q <= found; })) << n << " " << kind;
        EXPECT_TRUE(std::all_of(nth, v.end(), [&](float q) { return q >= found; })) << n << " " << kind;
        std::sort(v.begin(), v.end());
        EXPECT_EQ(v, sorted) << "values were lost";
      }
    }
}

TEST(SigmaOfMedian, IsThatOfANormal) {
  dot::test::Random random(3);
  std::vector<double> v;
  for (int i = 0; i < 100000; ++i) v.push_back(std::abs(2 * random.normal()));
  EXPECT_NEAR(dot::kSigmaOfMedian * dot::median(v.begin(), v.end()), 2, 0.03);
}

}  // namespace
