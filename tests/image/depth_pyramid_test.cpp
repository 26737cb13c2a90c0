// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/depth_pyramid.hpp"

#include <gtest/gtest.h>

namespace {

using dot::DepthPyramid;
using dot::Image;

void fill(DepthPyramid& pyramid, int width, int height, int levels, float (*q)(int, int)) {
  const auto row = [&](int y, float* out) {
    for (int x = 0; x < width; ++x) out[x] = q(x, y);
  };
  pyramid.build(width, height, row, levels);
}

DepthPyramid make(int width, int height, int levels, float (*q)(int, int)) {
  DepthPyramid pyramid;
  fill(pyramid, width, height, levels, q);
  return pyramid;
}

TEST(DepthPyramid, PlaneStaysAPlane) {
  // u_l = (u_0 + 0.5) / 2^l - 0.5, so pixel x of level 2 lies at 4 x + 1.5.
  const DepthPyramid p =
      make(33, 18, 3, [](int x, int y) { return 1 + 0.001f * static_cast<float>(x) + 0.002f * static_cast<float>(y); });
  ASSERT_EQ(p.levels[2].width(), 8);
  ASSERT_EQ(p.levels[2].height(), 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(p.levels[2](x, y), 1 + 0.001 * (4 * x + 1.5) + 0.002 * (4 * y + 1.5), 1e-6);
}

TEST(DepthPyramid, EdgesAreNotMixed) {
  // A near surface left of x = 5 and a far one right of it: 5 is odd, so that blocks straddle the edge on each level.
  const DepthPyramid p = make(32, 16, 4, [](int x, int) { return x < 5 ? 0.5f : 0.1f; });
  for (const Image<float>& level : p.levels)
    for (int y = 0; y < level.height(); ++y)
      for (int x = 0; x < level.width(); ++x)
        EXPECT_TRUE(level(x, y) == 0.5f || level(x, y) == 0.1f) << level.width() << ": " << x;
  EXPECT_EQ(p.levels[1](2, 0), 0.5f);  // the nearer one wins
  EXPECT_EQ(p.levels[1](3, 0), 0.1f);
}

TEST(DepthPyramid, HolesNeitherSpreadNorCount) {
  const DepthPyramid p = make(16, 16, 3, [](int x, int y) { return (x + y) % 2 ? 0.25f : 0.f; });
  for (std::size_t l = 1; l < p.levels.size(); ++l)
    for (int y = 0; y < p.levels[l].height(); ++y)
      for (int x = 0; x < p.levels[l].width(); ++x) EXPECT_EQ(p.levels[l](x, y), 0.25f);
  const DepthPyramid none = make(16, 16, 3, [](int, int) { return 0.f; });
  EXPECT_EQ(none.levels[2](1, 1), 0.f);
}

TEST(DepthPyramid, RebuildsInPlace) {
  DepthPyramid p = make(16, 16, 3, [](int, int) { return 0.5f; });
  const float* memory = p.levels[1].row(0);
  fill(p, 16, 16, 3, [](int, int) { return 0.25f; });
  EXPECT_EQ(p.levels[1].row(0), memory);
  EXPECT_EQ(p.levels[2](0, 0), 0.25f);
}

}  // namespace
