// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/painted_image.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace {

using dot::Mask;
using dot::PaintedImage;

Mask box_of(int x, int y, int width, int height) {
  Mask mask;
  dot::fill_mask(
      {x, y, width, height}, [](int, int) { return true; }, mask);
  return mask;
}

template <typename T>
int count(const PaintedImage<T>& painted) {
  int set = 0;
  for (int y = 0; y < painted.image().height(); ++y)
    for (int x = 0; x < painted.image().width(); ++x) set += painted.image()(x, y) != 0;
  return set;
}

TEST(PaintedImage, ShowsWhatWasPainted) {
  PaintedImage<std::uint32_t> painted;
  painted.clear(20, 10);
  painted.paint(box_of(2, 3, 5, 4), 70000);
  painted.paint(box_of(5, 3, 5, 4), 2);
  EXPECT_EQ(painted.image()(2, 3), 70000u);
  EXPECT_EQ(painted.image()(6, 6), 2u) << "the last one is on top";
  EXPECT_EQ(count(painted), 8 * 4);
  EXPECT_EQ(painted.boxes().size(), 2u);
}

TEST(PaintedImage, IsClearedAgain) {
  PaintedImage<std::uint8_t> painted;
  for (const auto& [width, height] : {std::pair{20, 10}, {20, 10}, {10, 20}, {30, 30}}) {
    painted.clear(width, height);
    EXPECT_EQ(count(painted), 0);
    EXPECT_TRUE(painted.boxes().empty());
    painted.paint(box_of(0, 0, 6, 6), 1);
    painted.paint(box_of(width - 3, height - 2, 3, 2), 2);
    painted.image()(4, 8) = 3;
    painted.add({4, 8, 1, 1});
    EXPECT_EQ(count(painted), 36 + 6 + 1);
  }
}

TEST(PaintedImage, AnEmptyMaskChangesNothing) {
  PaintedImage<std::uint8_t> painted;
  painted.clear(20, 10);
  painted.paint(Mask{}, 1);
  EXPECT_EQ(count(painted), 0);
  EXPECT_TRUE(painted.boxes().empty());
}

TEST(PaintedImage, ReservesMemoryOnce) {
  PaintedImage<std::uint8_t> painted;
  painted.reserve(20, 10, 4);
  EXPECT_GE(painted.boxes().capacity(), 4u);
  ASSERT_EQ(painted.image().width(), 20);
  ASSERT_EQ(painted.image().height(), 10);
  EXPECT_EQ(count(painted), 0);
  painted.clear(20, 10);
  EXPECT_EQ(count(painted), 0);
  painted.paint(box_of(2, 3, 5, 4), 1);
  painted.reserve(20, 10, 2);
  EXPECT_EQ(count(painted), 5 * 4);
  EXPECT_EQ(painted.boxes().size(), 1u);
}

/// An exception may leave pixels outside of the boxes.
TEST(PaintedImage, ForgetsWhereItWasPainted) {
  PaintedImage<std::uint8_t> painted;
  painted.clear(20, 10);
  painted.image().fill(1);
  painted.forget();
  painted.clear(20, 10);
  EXPECT_EQ(count(painted), 0);
}

}  // namespace
