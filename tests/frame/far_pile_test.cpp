// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/far_pile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace {

using dot::FarPile;

constexpr int kWidth = 200, kHeight = 100;
constexpr double kNone = std::numeric_limits<double>::infinity();

/// Ground below the horizon, and above it something at `sky` metres, 0 = no depth, with an error of 1 %.
/// @param open share of the rows above the horizon. @param farthest metres, of the ground.
std::vector<float> street(double sky, double open = 0.3, double farthest = 200) {
  std::mt19937 random(3);
  std::normal_distribution<double> error(0, 0.01);
  std::vector<float> metres;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double below = y + 0.5 - open * kHeight, ground = std::min(farthest, 150 / std::max(below, 1e-3));
      metres.push_back(static_cast<float>((below < 0 ? sky : ground) * (1 - std::abs(error(random)))));
    }
  return metres;
}

double look(FarPile& pile, const std::vector<float>& metres, double max_depth = 400) {
  return pile.update({metres.data(), kWidth, kHeight, kWidth * 4, dot::PixelFormat::DepthF32}, max_depth);
}
double look_at_words(FarPile& pile, const std::vector<float>& metres) {
  std::vector<std::uint16_t> words;
  for (const float z : metres) words.push_back(static_cast<std::uint16_t>(z * 256));
  return pile.update({words.data(), kWidth, kHeight, kWidth * 2, dot::PixelFormat::DepthU16, 256}, 400);
}

TEST(FarPile, IsTheLastTenthOfTheDepthOfANetwork) {
  FarPile of_floats, of_words;
  EXPECT_NEAR(look(of_floats, street(80, 0.3, 80)), 72, 0.1);
  EXPECT_NEAR(look_at_words(of_words, street(80, 0.3, 80)), 72, 0.1);
  EXPECT_NEAR(of_floats.share(), 0.3, 0.05);
  EXPECT_NEAR(of_words.share(), 0.3, 0.05);
}

TEST(FarPile, IsNotThereWithoutASky) {
  FarPile pile;
  EXPECT_EQ(look(pile, street(0)), kNone);
  EXPECT_EQ(look(pile, street(0, 0)), kNone) << "all ground";
  EXPECT_EQ(look(pile, std::vector<float>(kWidth * kHeight, 0)), kNone) << "no depth";
  EXPECT_EQ(pile.share(), 0);
}

TEST(FarPile, IsNoWallOfARoom) {
  FarPile pile;
  EXPECT_EQ(look(pile, street(15, 0.3, 15)), kNone);
}

/// A street whose upper rows are woods, 190 m away, and some of them nearer.
std::vector<float> woods(int rows, int rows_before) {
  std::vector<float> metres = street(0);
  for (int y = 0; y < rows + rows_before; ++y)
    std::fill_n(metres.begin() + y * kWidth, kWidth, y < rows ? 190.0F : 170.0F);
  return metres;
}

TEST(FarPile, HasManyTimesThePixelsOfTheTenthBefore) {
  FarPile pile;
  EXPECT_EQ(look(pile, woods(18, 6)), kNone);
  EXPECT_NEAR(look(pile, woods(18, 3)), 171, 1);
}

TEST(FarPile, IsNoSmallPart) {
  FarPile pile;
  EXPECT_EQ(look(pile, street(80, 0.02, 70)), kNone);
}

TEST(FarPile, IsNoGroundFarBelow) {
  FarPile pile;
  EXPECT_EQ(look(pile, street(80, 0.8, 70)), kNone);
}

TEST(FarPile, IsOfDepthThatCounts) {
  FarPile pile;
  EXPECT_EQ(look(pile, street(80, 0.3, 60), 70), kNone);
}

TEST(FarPile, StaysUntilThereIsDepthBeyond) {
  FarPile pile;
  EXPECT_NEAR(look(pile, street(80, 0.3, 80)), 72, 0.1);
  EXPECT_NEAR(look(pile, street(80, 0.02, 80)), 72, 0.1) << "little sky in view";
  EXPECT_EQ(look(pile, street(0)), kNone);
  EXPECT_EQ(look(pile, street(80, 0.02, 80)), kNone);
}

TEST(FarPile, StaysInFramesWithoutDepth) {
  FarPile pile;
  look(pile, street(80, 0.3, 80));
  EXPECT_NEAR(pile.update({}, 400), 72, 0.1);
  EXPECT_EQ(pile.share(), 0);
}

TEST(FarPile, IsForgotten) {
  FarPile pile;
  look(pile, street(80, 0.3, 80));
  pile.forget();
  EXPECT_EQ(look(pile, street(80, 0.02, 80)), kNone);
}

}  // namespace
