// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eval {
namespace {

TEST(Statistics, RatioOfNothingIsNotANumber) {
  EXPECT_DOUBLE_EQ(ratio(3, 4), 0.75);
  EXPECT_TRUE(std::isnan(ratio(3, 0)));
}

TEST(Statistics, Means) {
  EXPECT_DOUBLE_EQ(mean({1, 2, 6}), 3);
  EXPECT_DOUBLE_EQ(root_mean_square({3, 4}), std::sqrt(12.5));
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(root_mean_square({})));
}

TEST(Statistics, MedianOfAnEvenNumberIsBetweenTheMiddleTwo) {
  EXPECT_DOUBLE_EQ(median({5, 1, 3}), 3);
  EXPECT_DOUBLE_EQ(median({7, 1, 3, 4}), 3.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(Statistics, PercentileIsLinearBetweenNeighbours) {
  // Position 0.9 * 3 = 2.7 of the sorted values.
  EXPECT_DOUBLE_EQ(percentile({40, 10, 30, 20}, 90), 37);
  EXPECT_DOUBLE_EQ(percentile({40, 10, 30, 20}, 0), 10);
  EXPECT_DOUBLE_EQ(percentile({40, 10, 30, 20}, 100), 40);
}

TEST(Statistics, MedianOfMostlyInfiniteValuesIsInfinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1, infinity, infinity, infinity}), infinity);
  EXPECT_EQ(median({1, 2, infinity}), 2);
}

}  // namespace
}  // namespace eval
