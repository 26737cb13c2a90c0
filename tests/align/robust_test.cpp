// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/robust.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"

namespace {

using dot::huber_cost;
using dot::huber_weight;
using dot::mad_sigma;
using dot::tukey_cost;
using dot::test::Random;

constexpr float k = 1.345f, c = 4.685f;

TEST(Huber, IsQuadraticThenLinear) {
  EXPECT_EQ(huber_cost(0, k), 0);
  EXPECT_FLOAT_EQ(huber_cost(1, k), 0.5f);
  EXPECT_FLOAT_EQ(huber_cost(11, k) - huber_cost(10, k), k);
  EXPECT_EQ(huber_weight(1.3f, k), 1);
  EXPECT_FLOAT_EQ(huber_weight(13.45f, k), 0.1f);
  for (float e = 0.1f; e < 20; e += 0.37f) {
    EXPECT_EQ(huber_cost(-e, k), huber_cost(e, k));
    EXPECT_EQ(huber_weight(-e, k), huber_weight(e, k));
  }
}

TEST(Huber, WeightIsTheSlopeOfTheCost) {
  const float h = 1e-2f;
  for (float e = -8; e < 8; e += 0.33f)
    EXPECT_NEAR((huber_cost(e + h, k) - huber_cost(e - h, k)) / (2 * h), huber_weight(e, k) * e, 2e-3);
}

TEST(Tukey, IsQuadraticThenConstant) {
  EXPECT_EQ(tukey_cost(0, c), 0);
  EXPECT_NEAR(tukey_cost(0.1f, c), 0.005, 1e-5);
  const float most = c * c / 6;
  EXPECT_FLOAT_EQ(tukey_cost(c, c), most);
  EXPECT_FLOAT_EQ(tukey_cost(100, c), most);
  EXPECT_FLOAT_EQ(tukey_cost(-100, c), most);
  float before = 0;
  for (float e = 0.05f; e < c; e += 0.05f) {
    EXPECT_GT(tukey_cost(e, c), before);
    EXPECT_EQ(tukey_cost(-e, c), tukey_cost(e, c));
    before = tukey_cost(e, c);
  }
}

TEST(Tukey, OfManyIsThatOfEach) {
  Random random(9);
  for (const std::size_t n : {0, 1, 3, 4, 5, 17, 255, 256, 257, 3001}) {
    dot::Buffer<float> r(n), extra(n), costs(n);
    const float s2 = 2.5f;
    for (std::size_t i = 0; i < n; ++i) {
      r[i] = i % 7 == 0 ? 0 : static_cast<float>(random.normal(6));
      extra[i] = static_cast<float>(random.uniform(0, 4));
    }
    dot::tukey_costs(r.data(), extra.data(), n, s2, c, costs.data());
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(costs[i], tukey_cost(r[i] / std::sqrt(s2 + extra[i]), c), 1e-5) << i << " of " << n;
  }
}

TEST(Tukey, SlopeRedescends) {
  const float h = 1e-2f;
  for (float e = -7; e < 7; e += 0.31f) {
    const float s = 1 - e * e / (c * c);
    EXPECT_NEAR((tukey_cost(e + h, c) - tukey_cost(e - h, c)) / (2 * h), std::abs(e) < c ? e * s * s : 0, 2e-3);
  }
}

TEST(Tukey, PrefersTheMajorityWhereHuberIsCapturedByAMinority) {
  // 100 weak points are right at the first pose, 30 strong ones at the second.
  double huber[2] = {0, 0}, tukey[2] = {0, 0};
  const auto add = [&](int pose, int count, float e) {
    huber[pose] += count * static_cast<double>(huber_cost(e, k));
    tukey[pose] += count * static_cast<double>(tukey_cost(e, c));
  };
  add(0, 100, 0.7f), add(0, 30, 30);
  add(1, 100, 5), add(1, 30, 0.7f);
  EXPECT_GT(huber[0], huber[1]);
  EXPECT_LT(tukey[0], tukey[1]);
}

TEST(Median, IsTheMiddleOfTheSorted) {
  Random random(8);
  for (int n = 1; n < 400; n += n < 110 ? 1 : 37)
    for (const double spread : {0.0, 1e-3, 2.0, 30.0}) {
      dot::Buffer<float> values;
      for (int i = 0; i < n; ++i) values.push_back(static_cast<float>(std::exp(spread * random.normal(1))));
      for (int i = 0; i < n / 7; ++i) values[static_cast<std::size_t>(i)] = i % 2 ? 0.f : values.back();
      dot::Buffer<float> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(dot::median_of_magnitudes(values), sorted[static_cast<std::size_t>(n / 2)]) << n << " " << spread;
    }
}

TEST(MadSigma, IsTheStandardDeviationOfANormal) {
  Random random(9);
  dot::Buffer<float> absolute;
  for (int i = 0; i < 20001; ++i) absolute.push_back(std::abs(static_cast<float>(random.normal(3))));
  EXPECT_NEAR(mad_sigma(absolute), 3, 0.1);  // 4 sigma: 1.17 sigma / sqrt(n) each
}

TEST(MadSigma, HardlyMindsOutliers) {
  Random random(10);
  dot::Buffer<float> absolute;
  for (int i = 0; i < 10001; ++i)
    absolute.push_back(static_cast<float>(i % 5 == 0 ? random.uniform(30, 200) : std::abs(random.normal(3))));
  EXPECT_GT(mad_sigma(absolute), 3);
  EXPECT_LT(mad_sigma(absolute), 1.35 * 3);  // the median is then the 0.625 quantile of the good ones, 0.887 sigma
}

TEST(MadSigma, OfFewAndOfNone) {
  dot::Buffer<float> values;
  EXPECT_EQ(mad_sigma(values), 0);
  values = {2};
  EXPECT_NEAR(mad_sigma(values), 2.965, 1e-3);
  values = {1, 9, 2, 8, 3};
  EXPECT_NEAR(mad_sigma(values), 1.4826 * 3, 1e-3);
}

}  // namespace
