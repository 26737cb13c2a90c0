// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/labels/grow.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "support/box_scene.hpp"
#include "support/random.hpp"

namespace {

using box_scene::back;
using box_scene::Box;
using box_scene::kFar;
using box_scene::kHeight;
using box_scene::kId;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kOther;
using box_scene::kWidth;
using box_scene::render;
using dot::Image;
using dot::SE3d;

struct Grown {
  int gained;
  Image<std::uint32_t> ids;
  std::array<int, 4> box;
};

/// Grows the object, whose pixels in `current` lie in `box` (x, y, width, height).
Grown grow(const box_scene::Rendered& segmented, const box_scene::Rendered& current, const std::array<int, 4>& box,
           const SE3d& T_object, const SE3d& T_static = {}) {
  dot::GrowWorkspace workspace;
  Grown out{0, current.ids, box};
  out.gained = dot::grow(
      segmented, T_object, T_static, dot::Pinhole(box_scene::kIntrinsics), current.inverse_depth.view(), kId,
      [](double) { return 0.1; }, workspace, out.ids, out.box);
  return out;
}

/// The object must fill `box` and nothing else; `before` tells what the other pixels must still be.
void expect_fills(const Grown& found, const Image<std::uint32_t>& before, const std::array<int, 4>& box) {
  EXPECT_EQ(found.box, box);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= box[0] && x < box[0] + box[2] && y >= box[1] && y < box[1] + box[3];
      ASSERT_EQ(found.ids(x, y), inside ? kId : before(x, y)) << x << ' ' << y;
    }
}

void expect_unchanged(const Grown& found, const Image<std::uint32_t>& before, const std::array<int, 4>& box) {
  EXPECT_EQ(found.gained, 0);
  expect_fills(found, before, box);
}

TEST(Grow, FollowsTheObjectIntoTheImage) {
  for (const int shift : {10, 20}) {  // by less and by more than what was to be seen of it
    const auto segmented = render({{-shift, 24 - shift, 20, 40, kObject, kId}});
    auto current = render({{0, shift, 20, 40, kObject, 0}, {shift, 24, 20, 40, kObject, kId}});
    for (int y = 20; y < 40; y += 3)
      for (int x = 0; x < shift; x += 2) current.inverse_depth(x, y) = 0;  // not measured
    const Grown found = grow(segmented, current, {shift, 20, 24 - shift, 20}, back(shift));
    EXPECT_EQ(found.gained, shift * 20);
    expect_fills(found, current.ids, {0, 20, 24, 20});
  }
}

TEST(Grow, TakesWhatAnOccluderHid) {
  const auto segmented = render({{20, 44, 20, 40, kObject, kId}, {36, 44, 10, 50, kNear, kOther}});
  const auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}});
  const Grown found = grow(segmented, current, {30, 20, 16, 20}, back(10));
  EXPECT_EQ(found.gained, 8 * 20);
  expect_fills(found, current.ids, {30, 20, 24, 20});
}

TEST(Grow, LeavesWhatMayHaveStoodHidden) {
  // The wider occluder hid columns 46 to 49, too: a standing thing there would look the same.
  const auto segmented = render({{20, 44, 20, 40, kObject, kId}, {36, 50, 10, 50, kNear, kOther}});
  const auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 50, 20, 40, kObject, 0}});
  expect_unchanged(grow(segmented, current, {30, 20, 16, 20}, back(10)), current.ids, {30, 20, 16, 20});

  // The camera moved and the object stands: nothing tells it from what else comes into the image.
  const auto cut = render({{-10, 14, 20, 40, kObject, kId}});
  const auto entered = render({{0, 10, 20, 40, kObject, 0}, {10, 24, 20, 40, kObject, kId}});
  expect_unchanged(grow(cut, entered, {10, 20, 14, 20}, back(10), back(10)), entered.ids, {10, 20, 14, 20});
}

TEST(Grow, LeavesNeighboursAlone) {
  // Another object has come in below it, at the same depth.
  const auto segmented = render({{-10, 14, 20, 40, kObject, kId}});
  const auto current =
      render({{0, 10, 20, 40, kObject, 0}, {10, 24, 20, 40, kObject, kId}, {0, 24, 40, 50, kObject, kOther}});
  expect_fills(grow(segmented, current, {10, 20, 14, 20}, back(10)), current.ids, {0, 20, 24, 20});

  // Another object moves before it; its present mask is missing, but the segmented frame shows whose pixels they are.
  const auto pair = render({{10, 24, 20, 40, kObject, kId}, {24, 34, 20, 40, kObject, kOther}});
  const auto moved = render({{30, 44, 20, 40, kObject, kId}, {44, 54, 20, 40, kObject, 0}});
  expect_unchanged(grow(pair, moved, {30, 20, 14, 20}, back(20)), moved.ids, {30, 20, 14, 20});
}

TEST(Grow, LeavesGroundAndBackgroundAlone) {
  // The ground under it has its depth at the line of contact.
  const Box ground{0, kWidth, 40, kHeight, kObject, 0};
  const auto segmented = render({{-10, 14, 20, 40, kObject, kId}, ground});
  const auto current = render({{0, 10, 20, 40, kObject, 0}, {10, 24, 20, 40, kObject, kId}, ground});
  expect_fills(grow(segmented, current, {10, 20, 14, 20}, back(10)), current.ids, {0, 20, 24, 20});

  // Something farther has come in below it.
  const auto alone = render({{-10, 14, 20, 40, kObject, kId}});
  const auto both =
      render({{0, 10, 20, 40, kObject, 0}, {10, 24, 20, 40, kObject, kId}, {0, 24, 40, 50, kObject / 2, 0}});
  expect_fills(grow(alone, both, {10, 20, 14, 20}, back(10)), both.ids, {0, 20, 24, 20});
}

TEST(Grow, LeavesWhatTheSegmentationSaw) {
  // Depth reaches beyond the outline. Where the segmented frame shows the wall, or something at the object's depth that
  // was not given to it, nothing of the object was hidden.
  const auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}});
  for (const float beside : {kFar, kObject}) {
    const auto segmented = render({{20, 36, 20, 40, kObject, kId}, {36, 44, 20, 40, beside, 0}});
    expect_unchanged(grow(segmented, current, {30, 20, 16, 20}, back(10)), current.ids, {30, 20, 16, 20});
  }
}

// A pole stands before it; what has come in beyond is the object's as well. A broad thing would part it from others.
TEST(Grow, GoesOnBehindWhatIsNarrow) {
  for (const int width : {3, 4}) {  // the object's 10 x 20 pixels: a quarter of their root is 3
    const Box pole{20 - width, 20, 0, kHeight, kNear, 0};
    const auto segmented = render({{-20, 10, 20, 40, kObject, kId}, pole});
    const auto current = render({{0, 20, 20, 40, kObject, 0}, {20, 30, 20, 40, kObject, kId}, pole});
    const Grown found = grow(segmented, current, {20, 20, 10, 20}, back(20));
    if (width > 3) {
      expect_unchanged(found, current.ids, {20, 20, 10, 20});
      continue;
    }
    EXPECT_EQ(found.gained, (20 - width) * 20);
    EXPECT_EQ(found.box, (std::array<int, 4>{0, 20, 30, 20}));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        ASSERT_EQ(found.ids(x, y), x < 30 && y >= 20 && y < 40 && !(x >= 17 && x < 20) ? kId : 0) << x << ' ' << y;
  }
}

// Stereo measures nothing at the border of the image and beside edges. What was measured next to that may have hidden
// the object there, if it is nearer; if it is farther, the segmentation would have shown the object.
TEST(Grow, TakesWhatWasHiddenWhereNothingWasMeasured) {
  for (const bool wall : {true, false}) {
    auto segmented = render({{0, 24, 20, 40, kObject, kId}, {0, 12, 0, kHeight, wall ? kNear : kFar, 0}});
    auto current = render({{10, 34, 20, 40, kObject, 0}, {22, 34, 20, 40, kObject, kId}});
    for (int y = 0; y < kHeight; ++y)
      for (int x = 10; x < 12; ++x) segmented.inverse_depth(x, y) = 0;  // there it would have been two pixels
    current.inverse_depth(20, 25) = 0;                                  // and this may be anything
    const Grown found = grow(segmented, current, {22, 20, 12, 20}, back(10));
    // What is at columns 10 and 11 now may have stood there then.
    EXPECT_EQ(found.gained, wall ? 10 * 20 - 1 : 0);
    EXPECT_EQ(found.ids(20, 25), 0u);
    EXPECT_EQ(found.ids(21, 25), wall ? kId : 0u);
  }
}

/// Whichever part of a row is looked at, and at the borders of an image of any size.
TEST(Grow, TheRimIsBesideFreePixelsOfTheImage) {
  dot::test::Random random(1);
  std::vector<std::uint8_t> rim;
  for (const auto& [width, height] : {std::array<int, 2>{1, 1}, {1, 7}, {2, 2}, {40, 9}}) {
    dot::Image<std::uint32_t> ids(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) ids(x, y) = static_cast<std::uint32_t>(random.uniform(0, 2.99));
    const auto is_free = [&](int x, int y) { return ids.contains(x, y) && ids(x, y) == 0; };
    for (int y = 0; y < height; ++y)
      for (int x0 = 0; x0 < width; ++x0)
        for (int x1 = x0 + 1; x1 <= width; ++x1) {
          const int count = dot::find_rim(ids, 2, y, x0, x1, rim);
          int own = 0;
          for (int x = x0; x < x1; ++x) {
            own += ids(x, y) == 2;
            const bool beside = is_free(x - 1, y) || is_free(x + 1, y) || is_free(x, y - 1) || is_free(x, y + 1);
            ASSERT_EQ(rim[static_cast<std::size_t>(x - x0)] != 0, ids(x, y) == 2 && beside) << x << ' ' << y;
          }
          ASSERT_EQ(count, own);
        }
  }
}

}  // namespace
