// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/camera_motion/cell_shift.hpp"

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "support/random.hpp"

namespace {

using dot::CellShift;
using dot::Image;
using dot::Intrinsics;
using dot::Pinhole;
using dot::SE3d;
using dot::StandingEdges;

constexpr int kCell = StandingEdges::kCell, kColumns = 12, kRows = 9;
constexpr int kWidth = kColumns * kCell + 2, kHeight = kRows * kCell + 2;

Pinhole camera() {
  Intrinsics k;
  k.fx = k.fy = 50, k.cx = 24.5, k.cy = 18.5, k.width = kWidth, k.height = kHeight;
  return Pinhole(k);
}

TEST(CellShift, FarthestIsOfACellAndTheRingAboutIt) {
  dot::test::Random random(3);
  const StandingEdges edges;
  const Pinhole pinhole = camera();
  for (const double holes : {0.0, 0.5, 0.97, 1.0}) {
    Image<float> q(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        q(x, y) = random.uniform() < holes ? 0.0f : static_cast<float>(random.uniform(0.01, 2));
    const CellShift<Pinhole> shift(edges, SE3d(), q, pinhole);
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        float farthest = 0;
        for (int y = row * kCell; y <= (row + 1) * kCell + 1; ++y)
          for (int x = column * kCell; x <= (column + 1) * kCell + 1; ++x)
            if (q(x, y) > 0 && (farthest == 0 || q(x, y) < farthest)) farthest = q(x, y);
        EXPECT_EQ(shift.farthest(column, row), farthest) << column << " " << row << " holes " << holes;
      }
  }
}

// A camera that moves to the right by t sees a point at the depth 1 / q move to the left by f q t.
TEST(CellShift, IsThatOfAPointAtThatDepth) {
  const StandingEdges edges;
  const Pinhole pinhole = camera();
  Image<float> depth(kWidth, kHeight);
  depth.fill(0.5f);
  SE3d T_cur_last;
  T_cur_last.t.x() = -0.1;
  const CellShift<Pinhole> shift(edges, T_cur_last, depth, pinhole);
  dot::Vector2<float> from;
  ASSERT_TRUE(shift(5, 4, 0.5f, from));
  EXPECT_NEAR(from.x(), 50 * 0.5 * 0.1, 1e-4);
  EXPECT_NEAR(from.y(), 0, 1e-4);
  EXPECT_FALSE(shift(5, 4, 0, from));  // it has no depth
}

}  // namespace
