// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/pearson.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/random.hpp"

namespace {

using dot::Pearson;
using dot::test::Random;

struct Samples {
  std::vector<double> x, y;

  explicit Samples(unsigned seed, double noise = 20) {
    Random random(seed);
    for (int i = 0; i < 400; ++i) {
      x.push_back(random.uniform(0, 255));
      y.push_back(0.7 * x.back() + 12 + random.normal(noise));
    }
  }
  Pearson sums(double gain = 1, double offset = 0) const {
    Pearson p;
    for (std::size_t i = 0; i < x.size(); ++i) p.add(x[i], gain * y[i] + offset);
    return p;
  }
};

TEST(Pearson, IsTheTextbookFormula) {
  const Samples s(1);
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
  const double n = static_cast<double>(s.x.size());
  for (std::size_t i = 0; i < s.x.size(); ++i) mean_x += s.x[i] / n, mean_y += s.y[i] / n;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    xx += (s.x[i] - mean_x) * (s.x[i] - mean_x);
    xy += (s.x[i] - mean_x) * (s.y[i] - mean_y);
    yy += (s.y[i] - mean_y) * (s.y[i] - mean_y);
  }
  const Pearson p = s.sums();
  EXPECT_NEAR(p.correlation(), xy / std::sqrt(xx * yy), 1e-12);
  EXPECT_NEAR(p.slope(), xy / xx, 1e-12);
  EXPECT_NEAR(p.intercept(), mean_y - xy / xx * mean_x, 1e-9);
}

TEST(Pearson, IsInvariantToGainAndOffset) {
  const Samples s(2);
  const double phi = s.sums().correlation();
  EXPECT_GT(phi, 0.8);
  EXPECT_LT(phi, 0.99);
  EXPECT_NEAR(s.sums(0.3, 50).correlation(), phi, 1e-12);
  EXPECT_NEAR(s.sums(2.5, -90).correlation(), phi, 1e-12);
  EXPECT_NEAR(s.sums(-1, 255).correlation(), -phi, 1e-12);  // a negative is not a match
}

TEST(Pearson, OfALineIsOne) {
  const Samples s(3, 0);
  const Pearson p = s.sums(2, -30);
  EXPECT_NEAR(p.correlation(), 1, 1e-12);
  EXPECT_NEAR(p.slope(), 1.4, 1e-12);
  EXPECT_NEAR(p.intercept(), -6, 1e-9);
}

TEST(Pearson, OfUnrelatedValuesIsAboutZero) {
  Random random(4);
  Pearson p;
  for (int i = 0; i < 2500; ++i) {
    const double x = random.uniform(0, 255);
    p.add(x, random.uniform(0, 255));
  }
  EXPECT_NEAR(p.correlation(), 0, 4 / 50.0);  // 4 sigma of 1 / sqrt(n)
}

TEST(Pearson, IsZeroWhereSomethingDoesNotVary) {
  Pearson nothing, still, flat;
  for (int i = 0; i < 10; ++i) still.add(50, i), flat.add(i, 50);
  EXPECT_EQ(nothing.correlation(), 0);
  EXPECT_EQ(still.correlation(), 0);
  EXPECT_EQ(still.slope(), 0);
  EXPECT_EQ(flat.correlation(), 0);
  EXPECT_EQ(flat.slope(), 0);
  EXPECT_EQ(flat.intercept(), 50);
}

TEST(Pearson, SurvivesALargeOffset) {
  // Sums of squares about zero would lose all digits here.
  Pearson p;
  for (int i = 0; i < 100; ++i) p.add(1e9 + i, 1e9 - 3 * i);
  EXPECT_NEAR(p.correlation(), -1, 1e-9);
  EXPECT_NEAR(p.slope(), -3, 1e-6);
}

}  // namespace
