// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/inconsistency.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "support/random.hpp"

namespace {

using dot::CellFrame;
using dot::CellMotion;
using dot::DepthNoise;
using dot::Image;
using dot::Inconsistency;
using dot::Pinhole;
using dot::SE3d;
using dot::Vector3;

constexpr int width = 60, height = 40;
constexpr float wall = 0.05f, box = 0.1f;  // 1/m

/// Cells of a wall with a box of the given columns before it, rows 10 to 30; all of one grey value.
CellFrame scene(int box_begin, int box_end, float box_q = box) {
  Image<float> q(width, height);
  Image<std::uint8_t> grey(width, height);
  q.fill(wall);
  grey.fill(100);
  for (int y = 10; y < 30; ++y)
    for (int x = box_begin; x < box_end; ++x) q(x, y) = box_q;
  CellFrame frame;
  frame.build(grey, q);
  return frame;
}

DepthNoise noise() {
  dot::DepthNoiseSettings settings;
  settings.source = dot::DepthSource::Stereo;
  return {settings, {400, 400, 0, 0, 4 * width, 4 * height, 0.5}};  // 0.3 px / 200 px m = 0.0015 1/m a pixel
}

struct Case {
  Pinhole camera{{100, 100, 29.5, 19.5, width, height, 0.5}};
  dot::InconsistencyTest<Pinhole, DepthNoise> test;
  Inconsistency out;
  CellMotion motion;

  Case() {
    test.prepare(camera);
    out.clear(width, height);
    motion.seconds = 0.1;
    motion.adjacent = true;
  }
  void compare(const CellFrame& current, const CellFrame& reference) {
    test(camera, noise(), current, reference, reference.q, motion, out);
  }
  void compare_older(const CellFrame& current, const CellFrame& reference) {
    const CellMotion last = motion;
    motion.adjacent = false;
    motion.seconds = 0.4;
    compare(current, reference);
    motion = last;
  }
  float photo(const CellFrame& current, const CellFrame& reference, int x, int y) const {
    return test.photo(camera, noise(), current, reference, motion, test.intensity_scale, x, y);
  }
  int seeds(int x0, int x1) const {
    int count = 0;
    for (int y = 10; y < 30; ++y)
      for (int x = x0; x < x1; ++x) count += out.depth(x, y) != 0;
    return count;
  }
};

TEST(Inconsistency, NothingWhereNothingMoves) {
  Case c;
  const CellFrame frame = scene(20, 40);
  c.compare(frame, frame);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      EXPECT_FALSE(c.out.depth(x, y)) << x << ' ' << y;
      EXPECT_LT(c.photo(frame, frame, x, y), 1) << x << ' ' << y;
    }
}

TEST(Inconsistency, CrossingThingEntersFreeSpace) {
  Case c;
  c.compare(scene(25, 45), scene(20, 40));
  EXPECT_EQ(c.seeds(41, 45), 4 * 20);  // its leading part, but for the cell that a fattened edge may explain
  EXPECT_EQ(c.seeds(20, 25), 0);       // what it uncovered
  EXPECT_EQ(c.seeds(26, 39), 0);       // where it was before as well
}

// Fattened edges and half a cell of error in the motion.
TEST(Inconsistency, ForgivesOneCell) {
  Case c;
  c.compare(scene(21, 41), scene(20, 40));
  EXPECT_EQ(c.seeds(0, width), 0);
  c.compare(scene(20, 40, 0.09f), scene(19, 41, 0.09f));  // as if its rim had gone to the wall
  c.compare(scene(20, 40, 0.06f), scene(19, 41, 0.06f));
  EXPECT_EQ(c.seeds(0, width), 0);
}

/// A box in columns 20 to 39 as a time-of-flight camera sees it: the cells about it see the wall as well, and lie
/// anywhere between.
CellFrame flying(unsigned seed) {
  const CellFrame exact = scene(20, 40);
  Image<float> q = exact.q;
  dot::test::Random random(seed);
  for (int y = 9; y < 31; ++y)
    for (int x = 19; x < 41; ++x)
      if (exact.q(x, y) == wall) q(x, y) += static_cast<float>(random.uniform()) * (box - wall);
  CellFrame frame;
  frame.build(exact.grey, q);
  return frame;
}

TEST(Inconsistency, FlyingPixelsOfWhatStandsSayNothing) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Case c;
    const CellFrame current = flying(2 * seed), before = flying(2 * seed + 1);
    c.compare_older(current, before);
    c.compare(current, before);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) EXPECT_FALSE(c.out.depth(x, y)) << x << ' ' << y;
  }
}

TEST(Inconsistency, NearerThingEntersFreeSpace) {
  Case c;
  c.compare(scene(20, 40, 0.12f), scene(20, 40));
  EXPECT_EQ(c.seeds(21, 39), 18 * 20);
}

TEST(Inconsistency, RecedingThingLeaves) {
  Case c;
  c.compare(scene(20, 40, 0.085f), scene(20, 40));
  EXPECT_EQ(c.seeds(21, 39), 18 * 20);
}

// The wall that something uncovered shows the same difference, but nothing of it in the last interval.
TEST(Inconsistency, UncoveredSurfaceHasNotReceded) {
  const CellFrame now = scene(0, 0), before = scene(0, 0), old = scene(20, 40, 0.06f);
  Case c;
  c.compare_older(now, old);
  c.compare(now, before);
  EXPECT_EQ(c.seeds(0, width), 0);

  // A surface that went as far in steady steps has.
  Case steady;
  steady.compare_older(scene(20, 40, 0.05f), old);
  EXPECT_EQ(steady.seeds(22, 38), 0);
  steady.compare(scene(20, 40, 0.05f), scene(20, 40, 0.0525f));
  EXPECT_EQ(steady.seeds(22, 38), 16 * 20);
}

// A cell of the last frame tells the rate for the 2x2 cells about its place.
TEST(Inconsistency, ARateIsWantedBesideTheCellThatTellsIt) {
  const CellFrame now = scene(0, 0);
  CellFrame before = scene(0, 0);
  before.q(30, 20) = 0.055f;  // less than three sigmas
  Case c;
  c.out.contradict_if(31, 20, 0.01f);
  c.out.contradict_if(33, 20, 0.01f);
  c.compare(now, before);
  EXPECT_TRUE(c.out.depth(31, 20));
  EXPECT_FALSE(c.out.depth(30, 20)) << "no older frame contradicts it";
  EXPECT_FALSE(c.out.depth(33, 20)) << "it does not recede";
}

// A camera that moves sideways sees other parts of the wall beside the box: parallax, not motion.
TEST(Inconsistency, ParallaxIsExplained) {
  Case c;
  c.motion.T_cur_ref = SE3d::translation(Vector3<double>(-0.5, 0, 0));  // 5 cells on the box, 2.5 on the wall
  c.compare(scene(15, 35), scene(20, 40));
  EXPECT_EQ(c.seeds(0, width), 0);
}

TEST(Inconsistency, DoubtAboutTheCameraCounts) {
  Case sure, unsure;
  unsure.motion.translation_sigma = 1;
  sure.compare(scene(20, 40, 0.115f), scene(20, 40));
  unsure.compare(scene(20, 40, 0.115f), scene(20, 40));
  EXPECT_TRUE(sure.out.depth(30, 20));
  EXPECT_FALSE(unsure.out.depth(30, 20));
}

TEST(Inconsistency, IntensityAfterGainAndOffset) {
  CellFrame now = scene(0, 0), before = scene(0, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) now.grey(x, y) = 85;  // 0.8 * 100 + 5
  for (int y = 15; y < 25; ++y)
    for (int x = 20; x < 30; ++x) now.grey(x, y) = 60;
  Case c;
  c.motion.gain = 0.8;
  c.motion.offset = 5;
  c.compare(now, before);
  EXPECT_GT(c.photo(now, before, 25, 20), 10);
  EXPECT_LT(c.photo(now, before, 45, 20), 1);
}

// The scale is that of most cells where the depth agrees, at the gain and offset of the motion.
TEST(Inconsistency, ScaleOfTheResidualsIsThatOfTheNoise) {
  dot::test::Random random(1);
  CellFrame now = scene(0, 0);
  const CellFrame before = scene(20, 40);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) now.grey(x, y) = static_cast<std::uint8_t>(std::lround(100 + 6 * random.normal()));
  Case c;
  c.compare(now, before);
  EXPECT_NEAR(c.test.intensity_scale, 6, 0.8) << "within three standard deviations of such a sample's";
  c.motion.offset = 20;
  c.compare(now, before);
  EXPECT_GT(c.test.intensity_scale, 20);
  c.motion.offset = 0;
  CellFrame elsewhere = scene(0, 0);
  elsewhere.q.fill(6 * wall);
  c.compare(elsewhere, before);
  EXPECT_EQ(c.test.intensity_scale, 10) << "the depth agrees nowhere";
}

// Neither a place that the reference does not show, nor one that is hidden there, nor the border.
TEST(Inconsistency, IntensityOfWhatTheReferenceDoesNotShowSaysNothing) {
  CellFrame now = scene(0, 0), before = scene(20, 40, 0.2f);
  for (const int x : {0, 30, 50, width - 1}) now.grey(x, 20) = 200;
  Case c;
  c.compare(now, before);
  EXPECT_GT(c.photo(now, before, 50, 20), 10);
  EXPECT_EQ(c.photo(now, before, 30, 20), 0) << "behind the box";
  EXPECT_EQ(c.photo(now, before, 0, 20), 0);
  EXPECT_EQ(c.photo(now, before, width - 1, 20), 0);
  now.q(50, 20) = 0;
  EXPECT_EQ(c.photo(now, before, 50, 20), 0) << "no depth";
}

TEST(Inconsistency, NoMeasurementSaysNothing) {
  CellFrame empty = scene(0, 0);
  empty.q.fill(0);
  empty.nearest.fill(0);
  empty.farthest.fill(0);
  Case c;
  c.compare(scene(20, 40), empty);
  c.compare(empty, scene(20, 40));
  EXPECT_EQ(c.seeds(0, width), 0);
}

}  // namespace
