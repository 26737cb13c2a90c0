// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/region_painter.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Image;
using dot::Mask;

constexpr int cell = 4, width = 60, height = 40;

/// A thing at pixels [81, 161) x [39, 121) before a wall, and its cells.
struct Case {
  Image<float> q{width, height}, pixels{width * cell, height*cell};
  std::vector<int> region;
  dot::RegionPainter painter;
  Mask mask;

  Case() {
    pixels.fill(0.05f);
    q.fill(0.05f);
    for (int y = 39; y < 121; ++y)
      for (int x = 81; x < 161; ++x) pixels(x, y) = 0.1f;
    for (int y = 10; y < 30; ++y)
      for (int x = 20; x < 40; ++x) q(x, y) = 0.1f, region.push_back(y * width + x);
  }
  void paint() {
    painter(
        region, q, pixels, cell, [](float) { return 0.0005f; }, mask);
  }
};

TEST(RegionPainter, DrawsTheBorderByThePixelsDepth) {
  Case c;
  c.paint();
  EXPECT_EQ(c.mask.box(), (std::array<int, 4>{81, 39, 80, 82}));
  EXPECT_EQ(c.mask.area, 80 * 82);
}

TEST(RegionPainter, FillsWhatIsEnclosed) {
  Case c;
  for (int y = 60; y < 84; ++y)
    for (int x = 100; x < 132; ++x) c.pixels(x, y) = x < 116 ? 0 : 0.05f;  // a window: no depth, or what is behind
  std::vector<int> frame;
  for (const int i : c.region)
    if (const int x = i % width, y = i / width; x < 25 || x >= 33 || y < 15 || y >= 21) frame.push_back(i);
  c.region = frame;
  c.paint();
  EXPECT_TRUE(c.mask.at(108, 72));
  EXPECT_TRUE(c.mask.at(124, 72));
}

// A sky without depth above a roof is not the roof's.
TEST(RegionPainter, PixelsWithoutDepthCountInsideOnly) {
  Case c;
  for (int y = 0; y < 42; ++y)
    for (int x = 0; x < c.pixels.width(); ++x) c.pixels(x, y) = 0;
  for (int y = 80; y < 90; ++y)
    for (int x = 110; x < 120; ++x) c.pixels(x, y) = 0;
  c.paint();
  EXPECT_EQ(c.mask.y, 42);
  EXPECT_TRUE(c.mask.at(115, 85));
}

TEST(RegionPainter, EndsAtTheImage) {
  Case c;
  c.region.clear();
  c.q.fill(0.1f);
  c.pixels.fill(0.1f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 5; ++x) c.region.push_back(y * width + x);
  c.paint();
  EXPECT_EQ(c.mask.x, 0);
  EXPECT_EQ(c.mask.y, 0);
  EXPECT_EQ(c.mask.height(), height * cell);
}

}  // namespace
