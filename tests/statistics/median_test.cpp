// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/statistics/median.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(SigmaOfMedian, IsThatOfANormal) {
  dot::test::Random random(3);
  std::vector<double> v;
  for (int i = 0; i < 100000; ++i) v.push_back(std::abs(2 * random.normal()));
  EXPECT_NEAR(dot::kSigmaOfMedian * dot::median(v.begin(), v.end()), 2, 0.03);
}

}  // namespace
