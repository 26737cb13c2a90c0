// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/region_grower.hpp"

#include <gtest/gtest.h>

namespace {

using dot::Image;
using dot::Inconsistency;
using dot::RegionGrower;

constexpr int width = 80, height = 40;
constexpr float wall = 0.05f, thing = 0.1f;

/// A wall with a thing 30 x 20 cells large before it.
struct Case {
  Image<float> q{width, height};
  Image<std::uint8_t> followed{width, height};
  Inconsistency evidence;
  Image<std::uint8_t> photo{width, height};  ///< non-zero: contradicts by its grey value
  RegionGrower grower;

  Case() {
    q.fill(wall);
    followed.fill(0);
    photo.fill(0);
    evidence.clear(width, height);
    for (int y = 10; y < 30; ++y)
      for (int x = 20; x < 50; ++x) q(x, y) = thing;
  }
  template <typename Value>
  static void set(Image<Value>& image, int x0, int x1, Value value, int y0 = 10, int y1 = 30) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) image(x, y) = value;
  }
  const std::vector<std::vector<int>>& grow() {
    grower(
        q, evidence, followed, [](float) { return 0.0005f; }, [](int, int y) { return y < 36; },
        [this](int x, int y) { return evidence.depth(x, y) || photo(x, y); });
    return grower.regions;
  }
};

TEST(RegionGrower, GrowsOverContinuousDepth) {
  Case c;
  c.set(c.evidence.depth, 30, 50, std::uint8_t{255});
  ASSERT_EQ(c.grow().size(), 1u);
  const std::vector<int>& region = c.grower.regions[0];
  EXPECT_EQ(region.size(), 30u * 20u);  // all of the thing, nothing of the wall
  for (const int i : region) EXPECT_EQ(c.q.row(0)[i], thing);
}

TEST(RegionGrower, GrowsNoFartherThanTheEvidenceAllows) {
  Case c;
  c.set(c.q, 0, width, thing);
  c.set(c.evidence.depth, 30, 40, std::uint8_t{255});
  ASSERT_EQ(c.grow().size(), 1u);
  int left = width, right = 0;
  for (const int i : c.grower.regions[0]) left = std::min(left, i % width), right = std::max(right, i % width);
  EXPECT_EQ(left, 30 - 8);  // 1 + half the root of 200 cells
  EXPECT_EQ(right, 39 + 8);
}

TEST(RegionGrower, FewSeedsAreNoise) {
  Case c;
  c.set(c.q, 60, 65, 0.2f, 15, 16);
  c.set(c.evidence.depth, 60, 65, std::uint8_t{255}, 15, 16);
  EXPECT_TRUE(c.grow().empty());
}

TEST(RegionGrower, IntensityAloneGivesNoSeeds) {
  Case c;
  c.set<std::uint8_t>(c.photo, 20, 50, 1);
  EXPECT_TRUE(c.grow().empty());
}

TEST(RegionGrower, ClosedCellsAreLeftOut) {
  Case c;
  c.set(c.evidence.depth, 20, 50, std::uint8_t{255}, 36, 40);
  EXPECT_TRUE(c.grow().empty());
}

TEST(RegionGrower, DoesNotGrowIntoClosedCells) {
  Case c;
  c.set(c.q, 20, 50, thing, 10, 40);  // closed from row 36 on
  c.set(c.evidence.depth, 20, 50, std::uint8_t{255}, 20, 34);
  ASSERT_EQ(c.grow().size(), 1u);
  int bottom = 0;
  for (const int i : c.grower.regions[0]) bottom = std::max(bottom, i / width);
  EXPECT_EQ(bottom, 35);
}

TEST(RegionGrower, PartsOfAFollowedThingAreOne) {
  Case c;
  c.set(c.q, 34, 36, 0.2f);  // a post before it
  c.set(c.evidence.depth, 20, 34, std::uint8_t{255});
  c.set(c.evidence.depth, 36, 50, std::uint8_t{255});
  EXPECT_EQ(c.grow().size(), 2u);
  c.set(c.followed, 20, 34, std::uint8_t{3});
  c.set(c.followed, 36, 50, std::uint8_t{3});
  ASSERT_EQ(c.grow().size(), 1u);
  EXPECT_EQ(c.grower.regions[0].size(), 28u * 20u);
  c.set(c.followed, 36, 50, std::uint8_t{4});
  EXPECT_EQ(c.grow().size(), 2u);
}

TEST(RegionGrower, FollowedThingStaysWithLittleEvidence) {
  Case c;
  c.set(c.followed, 20, 50, std::uint8_t{1});
  ASSERT_EQ(c.grow().size(), 1u);
  EXPECT_EQ(c.grower.regions[0].size(), 30u * 20u);
}

}  // namespace
