// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera/depth_bias.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using dot::DepthBias;

TEST(DepthBias, IsThePolynomialThatItSays) {
  DepthBias bias;
  EXPECT_TRUE(bias.is_zero());
  EXPECT_EQ(bias(0.3, -0.7), 0);
  bias.coefficients << 1, 2, 3, 4, 5, 6, 7;
  EXPECT_FALSE(bias.is_zero());
  EXPECT_DOUBLE_EQ(bias(0, 0), 1);
  EXPECT_DOUBLE_EQ(bias(1, 0), 15);
  EXPECT_DOUBLE_EQ(bias(-1, 0), 3);
  EXPECT_DOUBLE_EQ(bias(-1, 1), 2);
  EXPECT_DOUBLE_EQ(bias(0.5, -1), 1 + 1 + 0.75 + 0.5 + 0.3125 - 6 - 3.5);
}

// Of s^2 + 3 st: the mean of s^4 is 1/5, that of s^2 t^2 is 1/9, and s^3 t averages out.
TEST(DepthBias, HasTheMeanSquareOfThePolynomial) {
  DepthBias bias;
  bias.coefficients << 0, 0, 1, 0, 0, 0, 3;
  EXPECT_NEAR(bias.rms(), std::sqrt(1.0 / 5 + 9.0 / 9), 0.01);
  bias.coefficients << 0.3, 0, 0, 0, 0, 0, 0;
  EXPECT_NEAR(bias.rms(), 0.3, 1e-12);
}

TEST(DepthBias, OfOneTinyCoefficientIsNotZero) {
  DepthBias bias;
  bias.coefficients[6] = 1e-12;
  EXPECT_FALSE(bias.is_zero());
}

}  // namespace
