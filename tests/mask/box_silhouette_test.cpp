// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/box_silhouette.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "dot/camera/pinhole.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::kFar;
using box_scene::kId;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::Noise;
using box_scene::Rendered;
using dot::BoxSilhouette;
using dot::Mask;

constexpr std::array<int, 4> kCar{30, 20, 20, 16};  // x, y, width, height: an object before the wall

Rendered car() { return box_scene::render({{kCar[0], kCar[0] + kCar[2], kCar[1], kCar[1] + kCar[3], kObject, kId}}); }

Mask rectangle(const std::array<int, 4>& box) { return box_scene::outline(box).mask; }

/// What is left of a box.
Mask cut(
    const Rendered& scene, const std::array<int, 4>& box, const Noise& noise = {},
    const std::function<bool(int, int)>& claimed = [](int, int) { return false; }) {
  BoxSilhouette silhouette;
  Mask mask = rectangle(box);
  const Mask whole = mask;
  const bool changed = silhouette.cut(scene.inverse_depth, dot::Pinhole(box_scene::kIntrinsics), noise, claimed, mask);
  EXPECT_EQ(changed, mask.area != whole.area);
  return mask;
}

TEST(BoxSilhouette, IsOfTheObjectInTheBox) {
  const Mask mask = cut(car(), {24, 14, 32, 26});
  EXPECT_EQ(mask.box(), kCar);
  EXPECT_EQ(mask.area, kCar[2] * kCar[3]);
}

TEST(BoxSilhouette, OfAThinObjectIsNotTheWallBehindIt) {
  const Rendered scene = box_scene::render({{34, 40, 10, 50, kObject, kId}});
  EXPECT_EQ(cut(scene, {22, 10, 30, 40}).box(), (std::array<int, 4>{34, 10, 6, 40}))
      << "a walker in a fifth of the box";
}

TEST(BoxSilhouette, KeepsWindows) {
  Rendered scene = car();
  for (int y = 24; y < 30; ++y)
    for (int x = 35; x < 45; ++x) scene.inverse_depth(x, y) = kFar;
  EXPECT_EQ(cut(scene, {24, 14, 32, 26}).area, kCar[2] * kCar[3]);
}

TEST(BoxSilhouette, LeavesOutWhatIsBeforeTheObject) {
  Rendered scene = car();
  for (int y = 0; y < box_scene::kHeight; ++y)
    for (int x = 24; x < 34; ++x) scene.inverse_depth(x, y) = kNear;
  EXPECT_EQ(cut(scene, {24, 18, 28, 18}).box(), (std::array<int, 4>{34, 20, 16, 16})) << "a pole hides its left end";
}

TEST(BoxSilhouette, GivesWhatIsNotMeasuredToTheNearestMeasurement) {
  Rendered scene = car();
  for (int y = 0; y < box_scene::kHeight; ++y)
    for (int x = 26; x < 32; ++x) scene.inverse_depth(x, y) = 0;
  // Columns 26 to 28 are nearer to the wall's columns up to 25, 29 to 31 to the car's from 32 on.
  EXPECT_EQ(cut(scene, {20, 14, 36, 26}).box(), (std::array<int, 4>{29, 20, 21, 16}));
}

TEST(BoxSilhouette, IsTheBoxWhereNothingTellsMore) {
  const auto stays = [](const Rendered& scene, const std::array<int, 4>& box, const Noise& noise = {}) {
    return cut(scene, box, noise).box() == box;
  };
  EXPECT_TRUE(stays(car(), kCar)) << "the object fills it";
  EXPECT_TRUE(stays(car(), {24, 14, 32, 26}, {0.1})) << "within the noise";
  Rendered dark = car();
  dark.inverse_depth.fill(0);
  EXPECT_TRUE(stays(dark, {24, 14, 32, 26})) << "no depth";
  EXPECT_TRUE(stays(box_scene::render({{36, 45, 23, 32, kObject, kId}}), {24, 14, 32, 26})) << "too little of it";
}

// Of a thing behind another one a strip is seen. The middle of its box shows the other one.
TEST(BoxSilhouette, IsOfWhatOtherMasksLeave) {
  const Rendered scene = box_scene::render({{30, 60, 10, 40, kFar * 2, kId}, {20, 52, 8, 44, kNear, kId}});
  const Mask strip = cut(scene, {30, 10, 30, 30}, {}, [](int u, int) { return u < 52; });
  EXPECT_EQ(strip.box(), (std::array<int, 4>{52, 10, 8, 30}));
  const Mask rim = cut(scene, {30, 10, 30, 30}, {}, [](int u, int) { return u < 58; });
  EXPECT_EQ(rim.box(), (std::array<int, 4>{30, 10, 22, 30})) << "so little may be what is about the object";
}

TEST(BoxSilhouette, KnowsABox) {
  EXPECT_TRUE(BoxSilhouette::is_box(rectangle({1, 2, 8, 8})));
  EXPECT_FALSE(BoxSilhouette::is_box(rectangle({1, 2, 7, 30}))) << "too small to cut";
  Mask ragged;
  dot::fill_mask(
      {5, 5, 20, 20}, [](int u, int v) { return u + v > 14; }, ragged);
  EXPECT_FALSE(BoxSilhouette::is_box(ragged));
}

}  // namespace
