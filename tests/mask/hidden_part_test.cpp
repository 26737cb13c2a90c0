// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/hidden_part.hpp"

#include <array>

#include <gtest/gtest.h>

#include "support/box_scene.hpp"

namespace {

using box_scene::kFar;
using box_scene::kId;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kOther;
using box_scene::outline;
using box_scene::render;

constexpr std::array<int, 4> kShown{20, 20, 16, 20}, kHidden{36, 20, 8, 20};

TEST(HiddenPart, IsWhatSomethingNearerHides) {
  auto segmented = render({{20, 44, 20, 40, kObject, kId}, {36, 44, 10, 50, kNear, kOther}});
  segmented.inverse_depth(40, 30) = 0;                // nothing measured
  segmented.inverse_depth(40, 31) = kObject * 1.05f;  // the object's own depth
  segmented.inverse_depth(19, 30) = kFar;             // one looks past it
  const dot::WarpedMask observed = outline(kShown);
  dot::HiddenPart part;
  part.add(outline({19, 20, 25, 20}), segmented.inverse_depth.view(), 0.1, observed.mask);
  dot::MaskTemplate hidden;
  part.make_template(hidden);
  EXPECT_TRUE(hidden.measured);
  EXPECT_EQ(hidden.mask.box(), kHidden);
  EXPECT_EQ(hidden.mask.area, 8 * 20 - 2);
  EXPECT_FALSE(hidden.mask.at(40, 30));
  EXPECT_FALSE(hidden.mask.at(40, 31));
  EXPECT_EQ(hidden.inverse_depth(0, 0), kObject);
  EXPECT_EQ(hidden.inverse_depth(40 - 36, 30 - 20), 0);

  // The same again, and more below: each pixel counts once.
  part.add(outline({30, 30, 14, 20}), segmented.inverse_depth.view(), 0.1, observed.mask);
  part.make_template(hidden);
  EXPECT_EQ(hidden.mask.box(), (std::array<int, 4>{36, 20, 8, 30}));
  EXPECT_EQ(hidden.mask.area, 8 * 30 - 2);

  part.clear();
  part.make_template(hidden);
  EXPECT_TRUE(hidden.mask.empty());
  EXPECT_FALSE(hidden.measured);
}

}  // namespace
