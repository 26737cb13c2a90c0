// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/depth_gap.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "dot/camera/pinhole.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::kFar;
using box_scene::kId;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::Noise;
using box_scene::Rendered;
using dot::Mask;

using Boxes = std::array<std::array<int, 4>, 2>;  // of the nearer and the farther part: x, y, width, height

constexpr std::array<int, 4> kMask{20, 15, 40, 30};

/// The boxes of the parts of a mask about all of kMask, if there are two.
std::optional<Boxes> parts_of(const Rendered& scene, const Noise& noise = {}) {
  dot::DepthGap gap;
  const Mask mask = box_scene::outline(kMask).mask;
  Mask near, far;
  if (!gap.find(scene.inverse_depth, dot::Pinhole(box_scene::kIntrinsics), noise, mask, near, far)) return std::nullopt;
  EXPECT_EQ(near.area + far.area, mask.area);
  EXPECT_EQ(dot::overlap(near, far), 0);
  return Boxes{near.box(), far.box()};
}

/// Columns 20 to `border` of the mask at 2 m, the others at `q`, 1/m.
Rendered pair(int border, float q) {
  return box_scene::render({{20, 60, 15, 45, q, kId}, {20, border, 15, 45, kNear, kId}});
}

TEST(DepthGap, PartsWhatIsBeforeFromWhatIsBehind) {
  EXPECT_EQ(parts_of(pair(40, kObject)), (Boxes{{{20, 15, 20, 30}, {40, 15, 20, 30}}}));
}

TEST(DepthGap, GivesWhatIsNotMeasuredToTheNearestPart) {
  Rendered scene = pair(40, kObject);
  for (int y = 15; y < 45; ++y)
    for (int x = 36; x < 42; ++x) scene.inverse_depth(x, y) = 0;
  EXPECT_EQ(parts_of(scene), (Boxes{{{20, 15, 19, 30}, {39, 15, 21, 30}}}));
}

TEST(DepthGap, IsLargerThanTheNearerPart) {
  EXPECT_EQ(parts_of(pair(40, 0.46f)), std::nullopt) << "17 cm, of a thing 60 cm high";
  EXPECT_EQ(parts_of(pair(40, kObject), {0.1}), std::nullopt) << "within the noise";
}

TEST(DepthGap, IsNotWhereSurfacesGoOn) {
  Rendered slope = pair(40, kObject);
  for (int y = 15; y < 45; ++y)
    for (int x = 20; x < 60; ++x) slope.inverse_depth(x, y) = 1 / (2 + 0.075f * static_cast<float>(x - 20));
  EXPECT_EQ(parts_of(slope), std::nullopt) << "a lorry seen from behind and aside";
}

TEST(DepthGap, LeavesOutRimsWindowsAndSpecks) {
  EXPECT_EQ(parts_of(pair(58, kFar)), std::nullopt) << "a rim of background";
  EXPECT_EQ(parts_of(box_scene::render({{20, 60, 15, 45, kNear, kId}, {30, 50, 22, 34, kFar, kId}})), std::nullopt)
      << "seen through a window";
  EXPECT_EQ(parts_of(box_scene::render({{20, 60, 15, 45, kNear, kId}, {54, 60, 15, 21, kFar, kId}})), std::nullopt)
      << "too small";
}

TEST(DepthGap, NeedsDepth) {
  Rendered dark = pair(40, kObject);
  dark.inverse_depth.fill(0);
  EXPECT_EQ(parts_of(dark), std::nullopt);
}

}  // namespace
