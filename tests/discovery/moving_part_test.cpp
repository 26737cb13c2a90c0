// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/moving_part.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Mask;
using dot::MovingPart;

constexpr int cell = 4, width = 30, height = 20;

/// A mask of 30x20 cells, all with depth and compared in two references, without any evidence.
struct Case {
  Mask mask;
  MovingPart part;

  Case() {
    dot::fill_mask(
        {8, 12, width * cell, height * cell}, [](int, int) { return true; }, mask);
    part.evidence.restart(mask, cell);
    part.evidence.references.fill(2);
    part.evidence.measured.fill(1);
  }
  /// Evidence of each cell of a box, in squared sigma; half of it by intensity.
  void set(int x0, int y0, int x1, int y1, float value) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        part.evidence.total(x, y) = 2 * value;
        part.evidence.intensity(x, y) = value;
      }
  }
  void find(bool contradicts = false) {
    part.find([=](int, int) { return contradicts; });
  }
  bool keeps(int x, int y) const { return mask.at(mask_x + x * cell + 1, mask_y + y * cell + 1); }
  int mask_x = 8, mask_y = 12;
};

TEST(MovingPart, IsCertainByTheIntensity) {
  Case c;
  c.set(5, 5, 15, 15, 8);  // 100 cells, 4 by intensity
  c.find();
  EXPECT_TRUE(c.part.is_comparable());
  EXPECT_EQ(c.part.certainty(), 1);
  c.part.evidence.intensity.fill(0);
  c.find();
  EXPECT_EQ(c.part.certainty(), 0) << "depth alone";
}

// A small region has too few cells for the evidence that a large one must have.
TEST(MovingPart, IsCertainOfASmallObject) {
  Case c;
  dot::fill_mask(
      {8, 12, 3 * cell, 4 * cell}, [](int, int) { return true; }, c.mask);
  c.part.evidence.restart(c.mask, cell);
  c.part.evidence.references.fill(2);
  c.set(0, 0, 3, 4, 8);  // 12 cells, 4 by intensity
  c.find();
  EXPECT_EQ(c.part.certainty(), 1);
  c.set(0, 0, 3, 4, 3);
  c.find();
  EXPECT_LT(c.part.certainty(), 0.5) << "1.5 by intensity";
}

TEST(MovingPart, SmallPartsDoNotAddUp) {
  Case c;
  for (int i = 0; i < 6; ++i) c.set(4 * i, 5, 4 * i + 2, 7, 8);
  c.find();
  EXPECT_LT(c.part.certainty(), 0.5);
}

TEST(MovingPart, IsNotComparableIfFewCellsAre) {
  Case c;
  c.part.evidence.references.fill(0);
  for (int x = 0; x < width; ++x) c.part.evidence.references(x, 3) = 1;
  c.find();
  EXPECT_FALSE(c.part.is_comparable());
  EXPECT_FALSE(c.part.is_mixed());
}

TEST(MovingPart, IsMixedIfAPartStands) {
  Case c;
  c.set(5, 5, 15, 15, 8);
  c.find();
  EXPECT_FALSE(c.part.is_mixed());
  c.set(20, 5, 23, 10, -8);  // 15 cells
  c.find();
  EXPECT_TRUE(c.part.is_mixed());
}

TEST(MovingPart, TakesOutWhatStands) {
  Case c;
  c.set(5, 5, 15, 15, 8);
  c.set(18, 0, 30, 20, -8);
  c.find();
  c.part.cut(c.mask);
  EXPECT_TRUE(c.keeps(5, 5) && c.keeps(14, 14) && c.keeps(10, 10));
  EXPECT_FALSE(c.keeps(25, 10)) << "it stands";
  EXPECT_FALSE(c.keeps(2, 10)) << "nothing tells that it moves";
  EXPECT_NEAR(c.mask.area, 100 * cell * cell, 44 * cell * cell) << "but for a cell at the border";
}

TEST(MovingPart, KeepsWhatLiesBetween) {
  Case c;
  c.set(5, 5, 8, 15, 8);    // the front of a vehicle
  c.set(8, 5, 16, 6, 8);    // its roof
  c.set(8, 13, 16, 15, 8);  // its wheels
  c.set(16, 5, 19, 15, 8);  // its back, and between them a side without texture
  c.set(24, 0, 30, 20, -8);
  c.find();
  c.part.cut(c.mask);
  EXPECT_TRUE(c.keeps(12, 9));
  EXPECT_FALSE(c.keeps(22, 9));
}

TEST(MovingPart, TakesOutAPostBeforeIt) {
  Case c;
  c.set(5, 5, 10, 15, 8);
  c.set(10, 5, 13, 15, -8);
  c.set(13, 5, 20, 15, 8);
  c.find();
  c.part.cut(c.mask);
  EXPECT_TRUE(c.keeps(6, 9) && c.keeps(18, 9)) << "both sides";
  EXPECT_FALSE(c.keeps(11, 9));
}

TEST(MovingPart, DropsASmallPartElsewhere) {
  Case c;
  c.set(5, 5, 15, 15, 8);
  c.set(24, 2, 27, 5, 8);
  c.set(0, 16, 30, 20, -8);
  c.find();
  c.part.cut(c.mask);
  EXPECT_TRUE(c.keeps(10, 10));
  EXPECT_FALSE(c.keeps(25, 3));
}

// What cannot be compared was hidden before. It is background, unless it also contradicts a static scene.
TEST(MovingPart, WhatCannotBeComparedMustContradict) {
  for (const bool contradicts : {false, true}) {
    Case c;
    c.set(5, 5, 15, 15, 8);
    c.set(0, 16, 30, 20, -8);
    for (int y = 5; y < 15; ++y)
      for (int x = 15; x < 20; ++x) c.part.evidence.references(x, y) = 0;
    c.find(contradicts);
    c.part.cut(c.mask);
    EXPECT_EQ(c.keeps(18, 10), contradicts);
  }
}

TEST(MovingPart, KeepsAllIfNothingWouldBeLeft) {
  Case c;
  c.set(0, 0, 30, 20, -8);
  c.find();
  EXPECT_TRUE(c.part.is_mixed());
  c.part.cut(c.mask);
  EXPECT_EQ(c.mask.area, width * height * cell * cell);
}

}  // namespace
