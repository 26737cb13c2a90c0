// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/shared_pixels.hpp"

#include <array>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/mask/observations.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::kFar;
using box_scene::kHeight;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kWidth;
using dot::Mask;

struct Noise {
  double sigma = 1e-3;
  double pixel_sigma(double) const { return sigma; }
};

Mask rectangle(int x, int y, int width, int height) { return box_scene::outline({x, y, width, height}).mask; }

/// A near thing in columns 20 to 39 and a farther one in columns 30 to 59, of which it hides a part.
box_scene::Rendered two_things() {
  return box_scene::render({{30, 60, 10, 50, kObject, box_scene::kOther}, {20, 40, 20, 40, kNear, box_scene::kId}});
}

TEST(SharedPixels, GoToTheObjectOfTheirDepth) {
  const box_scene::Rendered scene = two_things();
  for (const bool swapped : {false, true}) {
    Mask near = rectangle(15, 15, 30, 30), far = rectangle(30, 10, 30, 40), scratch;
    EXPECT_TRUE(swapped ? dot::separate(scene.inverse_depth, Noise{}, kObject, kNear, far, near, scratch)
                        : dot::separate(scene.inverse_depth, Noise{}, kNear, kObject, near, far, scratch));
    EXPECT_EQ(far.area, 30 * 40 - 10 * 20) << "all but what the near thing hides";
    EXPECT_EQ(dot::overlap(far, rectangle(20, 20, 20, 20)), 0);
    // In columns 30 to 44 the near thing's mask keeps what is its own.
    EXPECT_EQ(near.area, 15 * 30 + 10 * 20);
    EXPECT_EQ(near.box(), (std::array<int, 4>{15, 15, 25, 30})) << "the crop is tight";
  }
}

TEST(SharedPixels, StayInBothWhereItIsNotClear) {
  box_scene::Rendered scene = two_things();
  const Mask a = rectangle(15, 15, 30, 30), b = rectangle(30, 10, 30, 40);
  const auto unchanged = [&](const Noise& noise, float q_a, float q_b) {
    Mask near = a, far = b, scratch;
    const bool changed = dot::separate(scene.inverse_depth, noise, q_a, q_b, near, far, scratch);
    return !changed && near.area == a.area && far.area == b.area;
  };
  EXPECT_TRUE(unchanged({}, 1.04f * kObject, kObject)) << "two masks of one object";
  EXPECT_TRUE(unchanged({0.1}, kNear, kObject)) << "within the noise";
  EXPECT_TRUE(unchanged({}, 0, kObject)) << "no depth of one";
  EXPECT_TRUE(unchanged({}, kNear, 0)) << "no depth of the other";
  EXPECT_FALSE(unchanged({}, kNear, kObject));
  for (const float share : {0.48f, 0.52f}) {
    scene.inverse_depth.fill(share * kNear + (1 - share) * kObject);
    EXPECT_TRUE(unchanged({}, kNear, kObject)) << "between both";
  }
  scene.inverse_depth.fill(0);
  EXPECT_TRUE(unchanged({}, kNear, kObject)) << "not measured";
}

TEST(SharedPixels, MasksApartDoNotChange) {
  const box_scene::Rendered scene = two_things();
  for (const std::array<int, 2>& corner : {std::array<int, 2>{40, 0}, {0, 40}, {40, 40}}) {
    Mask a = rectangle(0, 0, 40, 40), b = rectangle(corner[0], corner[1], 20, 20), scratch;
    EXPECT_FALSE(dot::separate(scene.inverse_depth, Noise{}, kNear, kObject, a, b, scratch));
    EXPECT_EQ(a.area, 1600);
    EXPECT_EQ(b.area, 400);
  }
}

TEST(SharedPixels, OfAListOfBoxesAreSeparatedAsTheyAreRead) {
  const box_scene::Rendered scene = two_things();
  const dot::Pinhole camera(box_scene::kIntrinsics);
  dot::Image<std::uint8_t> filled;
  filled.resize(kWidth, kHeight);
  filled.fill(255);
  const auto box = [&](std::uint32_t id, int x, int y, int width, int height) {
    dot::Instance out;
    out.id = id;
    out.x = x, out.y = y;
    out.mask = {filled.row(0), width, height, kWidth, dot::PixelFormat::Grey8};
    return out;
  };
  const std::array<dot::Instance, 2> boxes{box(1, 20, 20, 20, 20), box(2, 30, 10, 30, 40)};
  dot::Masks masks;
  masks.instances = {boxes.data(), boxes.size()};
  dot::Observations observations;
  observations.count("masks", masks, 10, kWidth, kHeight);
  observations.read(masks, scene.inverse_depth, camera, Noise{});
  ASSERT_EQ(observations.list.size(), 2u);
  EXPECT_EQ(observations.list[0].mask.area, 400);
  EXPECT_EQ(observations.list[1].mask.area, 1000);
  EXPECT_EQ(dot::overlap(observations.list[0].mask, observations.list[1].mask), 0);
  // Its centre is that of what is left: in columns 30 to 59, without 30 to 39 in rows 20 to 39.
  const double column = (1200 * 44.5 - 200 * 34.5) / 1000;
  EXPECT_NEAR(observations.list[1].centre.x() * static_cast<double>(kObject) * 100 + 40, column, 0.01);
}

}  // namespace
