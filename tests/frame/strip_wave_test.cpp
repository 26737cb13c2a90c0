// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/strip_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace {

using Wave = dot::StripWave;
constexpr std::size_t kStrips = Wave::kStrips;
constexpr double kTurn = 6.283185307179586;

/// 0.3 + a sin(2 pi (p y + phase)) + h sin(4 pi (p y + phase)), with noise.
Wave::Values values(double periods, double amplitude, double harmonic = 0, double noise = 0) {
  dot::test::Random random(4);
  Wave::Values v;
  for (std::size_t i = 0; i < kStrips; ++i) {
    const double angle = kTurn * (periods * Wave::middle(i) + 0.2);
    v[i] =
        static_cast<float>(0.3 + amplitude * std::sin(angle) + harmonic * std::sin(2 * angle) + random.normal(noise));
  }
  return v;
}

double worst_error(const Wave& wave, const Wave::Values& exact) {
  double worst = 0;
  for (std::size_t i = 0; i < kStrips; ++i)
    worst = std::max(worst, std::abs(wave.at(Wave::middle(i)) + 0.3 - static_cast<double>(exact[i])));
  return worst;
}

TEST(StripWave, IsFound) {
  for (const double periods : {1.0, 1.6, 3.3, 6.0, 8.0}) {
    const Wave wave = Wave::fit(values(periods, 0.2, 0, 0.01), 1, 8, 0.03);
    EXPECT_NEAR(wave.periods, periods, 0.1);
    EXPECT_NEAR(wave.amplitude(), 0.2, 0.01);
    EXPECT_GT(wave.explained, 0.9);
    EXPECT_LT(worst_error(wave, values(periods, 0.2)), 0.04) << periods << " periods";
  }
}

TEST(StripWave, HasAHarmonicWhereTheStripsResolveIt) {
  for (const double periods : {2.0, 4.5}) {
    const Wave wave = Wave::fit(values(periods, 0.2, 0.05), 1, 8, 0.03);
    EXPECT_LT(worst_error(wave, values(periods, 0.2, 0.05)), 0.01) << periods << " periods";
  }
  const Wave wave = Wave::fit(values(7, 0.2, 0.05), 1, 8, 0.03);
  EXPECT_EQ(wave.terms.tail<2>().norm(), 0);
}

TEST(StripWave, BearsWrongAndMissingStrips) {
  Wave::Values v = values(3, 0.2);
  const Wave::Values exact = v;
  for (const std::size_t i : {0u, 1u, 2u, 3u}) v[i] = Wave::kNone;
  for (const std::size_t i : {20u, 21u, 35u}) v[i] += 0.5F;
  const Wave wave = Wave::fit(v, 1, 8, 0.03);
  EXPECT_NEAR(wave.periods, 3, 0.1);
  EXPECT_LT(worst_error(wave, exact), 0.03);
  v.fill(Wave::kNone);
  EXPECT_EQ(Wave::fit(v, 1, 8, 0.03).amplitude(), 0);
}

TEST(StripWave, IsNotSeenInNoiseOrInAStep) {
  EXPECT_LT(Wave::fit(values(1, 0, 0, 0.05), 1, 8, 0.03).explained, 0.4);
  Wave::Values step = values(1, 0, 0, 0.01);
  for (std::size_t i = 20; i < 24; ++i) step[i] += 0.4F;  // the horizon has moved by a few strips
  const Wave wave = Wave::fit(step, 1, 8, 0.03);
  EXPECT_LT(wave.explained, 0.5);
}

TEST(StripWave, WeakOnesAreNotRefined) {
  EXPECT_EQ(Wave::fit(values(3, 0.01), 1, 8, 0.03).explained, 0);
  EXPECT_GT(Wave::fit(values(3, 0.035), 1, 8, 0.03).explained, 0.9);
}

}  // namespace
