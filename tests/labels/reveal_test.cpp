// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/labels/reveal.hpp"

#include <array>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::back;
using box_scene::kFar;
using box_scene::kHeight;
using box_scene::kId;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kOther;
using box_scene::kWidth;
using box_scene::outline;
using box_scene::render;
using dot::SE3d;

struct Revealed {
  int gained;
  dot::Image<std::uint32_t> ids;
  std::array<int, 4> box;
};

/// The hidden part, ten pixels to the right of where it was.
Revealed reveal(const box_scene::Rendered& segmented, const box_scene::Rendered& current) {
  Revealed out{0, current.ids, {30, 20, 16, 20}};
  out.gained = dot::reveal(
      outline({46, 20, 8, 20}), segmented, back(10), SE3d{}, dot::Pinhole(box_scene::kIntrinsics),
      current.inverse_depth.view(), kId, [](double) { return 0.1; }, out.ids, out.box);
  return out;
}

// The occluder hid columns 46 to 49 of the background, too: growth would leave them.
TEST(Reveal, TakesWhatWasHiddenEitherWay) {
  const auto segmented = render({{20, 44, 20, 40, kObject, kId}, {36, 50, 10, 50, kNear, kOther}});
  auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}});
  current.inverse_depth(48, 30) = 0;
  current.inverse_depth(48, 31) = kFar;
  current.inverse_depth(48, 32) = kNear;
  current.ids(48, 33) = kOther;
  const Revealed found = reveal(segmented, current);
  EXPECT_EQ(found.gained, 8 * 20 - 4);
  EXPECT_EQ(found.box, (std::array<int, 4>{30, 20, 24, 20}));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool part = x >= 46 && x < 54 && y >= 20 && y < 40 && !(x == 48 && y >= 30 && y < 34);
      ASSERT_EQ(found.ids(x, y), part ? kId : current.ids(x, y)) << x << ' ' << y;
    }
}

TEST(Reveal, LeavesWhatStands) {
  // Something of the object's depth stood there and stands there.
  const auto segmented =
      render({{20, 44, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}, {36, 46, 10, 50, kNear, kOther}});
  const auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}});
  const Revealed found = reveal(segmented, current);
  EXPECT_EQ(found.gained, 0);
  EXPECT_EQ(found.box, (std::array<int, 4>{30, 20, 16, 20}));
}

TEST(Reveal, LeavesWhatTheSegmentationWouldHaveShown) {
  // Nothing hid that part when it was segmented: it is not the object's.
  const auto segmented = render({{20, 36, 20, 40, kObject, kId}});
  const auto current = render({{30, 46, 20, 40, kObject, kId}, {46, 54, 20, 40, kObject, 0}});
  EXPECT_EQ(reveal(segmented, current).gained, 0);
}

}  // namespace
