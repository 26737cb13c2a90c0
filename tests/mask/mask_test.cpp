// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/mask.hpp"

#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/consistent_mask.hpp"

namespace {

using dot::Image;
using dot::ImageRef;
using dot::Mask;
using dot::PixelFormat;
using dot::test::expect_consistent;

/// A mask with random pixels in a random box.
Mask random_mask(std::mt19937& random, double density) {
  std::uniform_int_distribution<int> place(0, 12), size(1, 14);
  std::bernoulli_distribution set(density);
  Image<std::uint8_t> pixels(30, 30);
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 30; ++u) pixels(u, v) = set(random);
  Mask mask;
  dot::fill_mask(
      {place(random), place(random), size(random), size(random)}, [&](int u, int v) { return pixels(u, v) != 0; },
      mask);
  return mask;
}

TEST(Mask, IsCroppedToItsPixels) {
  Mask mask;
  dot::fill_mask(
      {2, 3, 20, 20}, [](int u, int v) { return (u == 7 && v == 9) || (u == 11 && v == 6); }, mask);
  EXPECT_EQ(mask.box(), (std::array<int, 4>{7, 6, 5, 4}));
  EXPECT_EQ(mask.area, 2);
  expect_consistent(mask);
  EXPECT_TRUE(mask.at(7, 9));
  EXPECT_TRUE(mask.at(11, 6));
  EXPECT_FALSE(mask.at(7, 6));

  dot::fill_mask(
      {2, 3, 20, 20}, [](int, int) { return false; }, mask);
  EXPECT_TRUE(mask.empty());
  EXPECT_EQ(mask.box(), (std::array<int, 4>{0, 0, 0, 0}));
}

TEST(Mask, AtIsFalseOutside) {
  Mask mask;
  dot::fill_mask(
      {5, 5, 3, 3}, [](int, int) { return true; }, mask);
  constexpr int far = std::numeric_limits<int>::max(), near = std::numeric_limits<int>::min();
  for (const auto& [u, v] : std::vector<std::pair<int, int>>{
           {4, 5}, {8, 5}, {5, 4}, {5, 8}, {far, 5}, {near, 5}, {5, far}, {5, near}, {near, near}, {-1, -1}})
    EXPECT_FALSE(mask.at(u, v)) << u << ' ' << v;
  EXPECT_TRUE(mask.at(5, 5));
  EXPECT_TRUE(mask.at(7, 7));
  EXPECT_FALSE(Mask{}.at(0, 0));
}

TEST(Mask, OverlapsEqualBruteForce) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const Mask a = random_mask(random, 0.5), b = random_mask(random, 0.5);
    expect_consistent(a);
    int both = 0;
    for (int v = 0; v < 40; ++v) {
      for (int u = 0; u < 40; ++u) both += a.at(u, v) && b.at(u, v);
    }
    EXPECT_EQ(dot::overlap(a, b), both);
    EXPECT_EQ(dot::overlap(b, a), both);
    EXPECT_DOUBLE_EQ(dot::containment(a, b), both > 0 ? double(both) / std::min(a.area, b.area) : 0);
  }
  EXPECT_EQ(dot::containment(Mask{}, Mask{}), 0);
}

TEST(Mask, CropsWithinABox) {
  Image<std::uint16_t> ids(10, 8);
  ids.fill(3);
  Mask mask;
  dot::crop_ids<std::uint16_t>(ids.view(), 3, {4, 2, 3, 30}, mask);
  EXPECT_EQ(mask.box(), (std::array<int, 4>{4, 2, 3, 6}));
  dot::crop_ids<std::uint16_t>(ids.view(), 4, {0, 0, 10, 8}, mask);
  EXPECT_TRUE(mask.empty());
  dot::crop_ids<std::uint16_t>(ids.view(), 3, {20, 20, 5, 5}, mask);
  EXPECT_TRUE(mask.empty());
}

/// The mask of an instance in a frame of 20 x 10 pixels.
Mask placed(const ImageRef& image, int x, int y) {
  Mask mask;
  dot::mask_of(image, x, y, 20, 10, mask);
  return mask;
}

TEST(Mask, OfAnInstanceIsClippedToTheFrame) {
  std::vector<std::uint8_t> pixels(6 * 5, 1);
  pixels[0] = 0;
  const ImageRef image{pixels.data(), 6, 5, 6, PixelFormat::Grey8, 1};

  Mask mask = placed(image, 3, 2);
  EXPECT_EQ(mask.box(), (std::array<int, 4>{3, 2, 6, 5}));
  EXPECT_EQ(mask.area, 29);
  EXPECT_FALSE(mask.at(3, 2));
  expect_consistent(mask);

  mask = placed(image, -4, -3);
  EXPECT_EQ(mask.box(), (std::array<int, 4>{0, 0, 2, 2}));
  mask = placed(image, 17, 8);
  EXPECT_EQ(mask.box(), (std::array<int, 4>{17, 8, 3, 2}));
  EXPECT_EQ(mask.area, 5);

  constexpr int far = std::numeric_limits<int>::max(), near = std::numeric_limits<int>::min();
  for (const auto& [x, y] :
       std::vector<std::pair<int, int>>{{far, 0}, {near, 0}, {0, far}, {0, near}, {-6, 0}, {20, 0}, {0, 10}})
    EXPECT_TRUE(placed(image, x, y).empty()) << x << ' ' << y;
  EXPECT_TRUE(placed(ImageRef{}, 0, 0).empty());
}

TEST(Mask, OfAnInstanceRefusesOtherFormats) {
  const std::vector<std::uint16_t> pixels(12, 1);
  EXPECT_THROW(placed({pixels.data(), 4, 3, 8, PixelFormat::Id16, 1}, 0, 0), std::invalid_argument);
}

}  // namespace
