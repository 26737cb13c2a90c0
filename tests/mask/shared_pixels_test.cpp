// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/shared_pixels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/mask/observations.hpp"
#include "support/box_scene.hpp"

namespace {

using box_scene::kHeight;
using box_scene::kNear;
using box_scene::kObject;
using box_scene::kWidth;
using box_scene::Noise;
using dot::Mask;

Mask rectangle(int x, int y, int width, int height) { return box_scene::outline({x, y, width, height}).mask; }

/// A near thing in columns 20 to 39 and a farther one in columns 30 to 59, of which it hides a part.
box_scene::Rendered two_things() {
  return box_scene::render({{30, 60, 10, 50, kObject, box_scene::kOther}, {20, 40, 20, 40, kNear, box_scene::kId}});
}

TEST(SharedPixels, GoToTheObjectOfTheirDepth) {
  const box_scene::Rendered scene = two_things();
  for (const bool swapped : {false, true}) {
    Mask near = rectangle(15, 15, 30, 30), far = rectangle(30, 10, 30, 40), scratch;
    EXPECT_TRUE(swapped ? dot::separate(scene.inverse_depth, Noise{}, kObject, kNear, far, near, nullptr, scratch)
                        : dot::separate(scene.inverse_depth, Noise{}, kNear, kObject, near, far, nullptr, scratch));
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
    const bool changed = dot::separate(scene.inverse_depth, noise, q_a, q_b, near, far, nullptr, scratch);
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

bool is_around(const Mask& outer, const Mask& inner) { return dot::gives_way({outer, 1}, {inner, 1}); }

TEST(SharedPixels, GoToTheInnerMaskWhereDepthDoesNotTell) {
  box_scene::Rendered scene = two_things();
  const auto areas = [&](float q_inner, float q_outer) {
    Mask outer = rectangle(10, 10, 60, 40), inner = rectangle(20, 20, 20, 20), scratch;
    EXPECT_TRUE(is_around(outer, inner));
    EXPECT_TRUE(dot::separate(scene.inverse_depth, Noise{}, q_inner, q_outer, inner, outer, &outer, scratch));
    return std::array<int, 2>{inner.area, outer.area};
  };
  const std::array<int, 2> all_inner{400, 2000}, half_each{200, 2200};
  EXPECT_EQ(areas(kNear, kNear), all_inner);
  EXPECT_EQ(areas(kNear, 0), all_inner);
  EXPECT_EQ(areas(0, kNear), all_inner);
  EXPECT_EQ(areas(kObject, kNear), (std::array<int, 2>{400 - 400, 2400})) << "all of it has the outer one's depth";
  for (int v = 20; v < 40; ++v)
    for (int u = 20; u < 30; ++u) scene.inverse_depth(u, v) = kObject;
  EXPECT_EQ(areas(kObject, kNear), half_each);
}

TEST(SharedPixels, OfALessSureMaskNeedNotBeMuchSmaller) {
  const Mask inner = rectangle(20, 20, 20, 20), outer = rectangle(20, 20, 20, 28);
  EXPECT_TRUE(dot::gives_way({outer, 0.5f}, {inner, 0.9f}));
  EXPECT_FALSE(dot::gives_way({outer, 0.9f}, {inner, 0.9f}));
  EXPECT_FALSE(dot::gives_way({outer, 0.9f}, {inner, 0.5f}));
}

TEST(SharedPixels, PeopleGiveNothingUpToThings) {
  const Mask inner = rectangle(20, 20, 20, 20), outer = rectangle(20, 20, 40, 40);
  EXPECT_FALSE(dot::gives_way({outer, 0.5f, true}, {inner, 0.9f, false}));
  EXPECT_FALSE(dot::gives_way({inner, 0.5f, true}, {inner, 0.9f, false}));
  EXPECT_TRUE(dot::gives_way({outer, 0.5f, true}, {inner, 0.9f, true}));
  EXPECT_TRUE(dot::gives_way({outer, 0.5f, false}, {inner, 0.9f, true}));
}

TEST(SharedPixels, OnlyAMuchLargerMaskIsAroundAnother) {
  const Mask inner = rectangle(20, 20, 20, 20);
  EXPECT_FALSE(is_around(rectangle(20, 20, 20, 28), inner)) << "two masks of one object";
  EXPECT_TRUE(is_around(rectangle(20, 20, 20, 31), inner));
  EXPECT_TRUE(is_around(rectangle(21, 20, 40, 31), inner)) << "it need not hold all of it";
  EXPECT_FALSE(is_around(rectangle(25, 20, 40, 31), inner));
  EXPECT_FALSE(is_around(inner, rectangle(20, 20, 20, 31)));
}

TEST(SharedPixels, MasksApartDoNotChange) {
  const box_scene::Rendered scene = two_things();
  for (const std::array<int, 2>& corner : {std::array<int, 2>{40, 0}, {0, 40}, {40, 40}}) {
    Mask a = rectangle(0, 0, 40, 40), b = rectangle(corner[0], corner[1], 20, 20), scratch;
    EXPECT_FALSE(dot::separate(scene.inverse_depth, Noise{}, kNear, kObject, a, b, nullptr, scratch));
    EXPECT_EQ(a.area, 1600);
    EXPECT_EQ(b.area, 400);
  }
}

/// Boxes of a detector in the image of `two_things`, as they are read.
class Boxes {
 public:
  Boxes() : filled_(kWidth, kHeight) { filled_.fill(255); }

  dot::ImageRef ids;  ///< of an image of ids beside the list

  void add(std::uint32_t id, const std::array<int, 4>& box, float score = 1) {
    dot::Instance& out = list_.emplace_back();
    out.id = id;
    out.score = score;
    out.x = box[0], out.y = box[1];
    out.mask = {filled_.row(0), box[2], box[3], kWidth, dot::PixelFormat::Grey8};
  }
  const dot::Observations& read() {
    dot::Masks masks;
    masks.instances = {list_.data(), list_.size()};
    masks.ids = ids;
    observations_.list.clear();
    observations_.count("masks", masks, 10, kWidth, kHeight);
    observations_.read(masks, two_things().inverse_depth, dot::Pinhole(box_scene::kIntrinsics), Noise{});
    return observations_;
  }
  /// Area of the mask of an id; 0: it was dropped.
  int area(std::uint32_t id) {
    const dot::Observations& read_ones = read();
    for (std::size_t i = 0; i < read_ones.list.size(); ++i)
      if (read_ones.list[i].instance_id == id) return read_ones.list[i].mask.area;
    return 0;
  }

 private:
  dot::Image<std::uint8_t> filled_;
  std::vector<dot::Instance> list_;
  dot::Observations observations_;
};

TEST(SharedPixels, AMaskOfTheWholeImageTakesNoneOfTheOthers) {
  Boxes boxes;
  boxes.add(1, {22, 22, 10, 10});
  boxes.add(2, {0, 0, kWidth, kHeight}, 0.3f);
  boxes.add(3, {40, 15, 10, 30});
  EXPECT_EQ(boxes.area(1), 100);
  EXPECT_EQ(boxes.area(3), 300);
  EXPECT_EQ(boxes.area(2), 1400 - 400) << "the two things without the others' pixels, and without the wall";
}

TEST(SharedPixels, AMaskOfAGroupIsDroppedBesideItsMembers) {
  for (const float score : {0.3f, 1.0f, 1.1f}) {
    Boxes boxes;
    boxes.add(1, {40, 10, 6, 40});
    boxes.add(2, {40, 10, 20, 40}, score);
    boxes.add(3, {50, 10, 6, 40});
    EXPECT_EQ(boxes.area(1), 240);
    EXPECT_EQ(boxes.area(3), 240);
    EXPECT_EQ(boxes.area(2), score > 1 ? 800 : 0) << "surer than its members?";
  }
}

TEST(SharedPixels, OfTwoMasksOfOneObjectTheSurerOneStays) {
  for (const float score : {0.5f, 0.9f, 1.0f}) {
    Boxes boxes;
    boxes.add(1, {40, 10, 20, 40}, 0.9f);
    boxes.add(2, {41, 11, 20, 40}, score);
    EXPECT_EQ(boxes.area(1), score > 0.9f ? 0 : 800) << score;
    EXPECT_EQ(boxes.area(2), score < 0.9f ? 0 : 19 * 39) << score << ": without the wall beside the thing";
  }
  Boxes neighbours;
  neighbours.add(1, {40, 10, 12, 40}, 0.9f);
  neighbours.add(2, {46, 10, 12, 40}, 0.5f);
  EXPECT_EQ(neighbours.area(1), 480);
  EXPECT_EQ(neighbours.area(2), 480);
}

// An image of ids alone has one id for each pixel. With masks beside it a pixel may have two.
TEST(SharedPixels, OfAnImageOfIdsAndOfMasksBesideItAreSeparated) {
  dot::Image<std::uint8_t> image(kWidth, kHeight);
  for (int y = 10; y < 50; ++y)
    for (int x = 30; x < 60; ++x) image(x, y) = 7;
  Boxes boxes;
  boxes.ids = {image.row(0), kWidth, kHeight, kWidth, dot::PixelFormat::Id8};
  EXPECT_EQ(boxes.area(7), 1200);
  boxes.add(1, {20, 20, 20, 20});
  EXPECT_EQ(boxes.area(1), 400);
  EXPECT_EQ(boxes.area(7), 1000);
}

TEST(SharedPixels, OfAListOfBoxesAreSeparatedAsTheyAreRead) {
  Boxes boxes;
  boxes.add(1, {20, 20, 20, 20});
  boxes.add(2, {30, 10, 30, 40});
  const dot::Observations& observations = boxes.read();
  ASSERT_EQ(observations.list.size(), 2u);
  EXPECT_EQ(observations.list[0].mask.area, 400);
  EXPECT_EQ(observations.list[1].mask.area, 1000);
  EXPECT_EQ(dot::overlap(observations.list[0].mask, observations.list[1].mask), 0);
  // Its centre is that of what is left: in columns 30 to 59, without 30 to 39 in rows 20 to 39.
  const double column = (1200 * 44.5 - 200 * 34.5) / 1000;
  EXPECT_NEAR(observations.list[1].centre.x() * static_cast<double>(kObject) * 100 + 40, column, 0.01);
}

}  // namespace
