// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/discovery/cell_evidence.hpp"

#include <gtest/gtest.h>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "support/random.hpp"

namespace {

using dot::CellComparison;
using dot::CellEvidence;
using dot::CellFrame;
using dot::DepthNoise;
using dot::Image;
using dot::Pinhole;
using dot::SE3d;
using dot::Vector3;

constexpr int width = 60, height = 40, first = 20, rows = 10;
constexpr float wall = 0.05f, box = 0.1f;  // 1/m
constexpr double shift = 6;                // cells; 0.1 focal lengths at 10 m are 10 cells

/// A textured wall with a box of 20x20 cells before it, whose texture goes with it.
CellFrame scene(int box_begin, int contrast = 100) {
  Image<float> q(width, height);
  Image<std::uint8_t> grey(width, height);
  dot::test::Random random(1);
  Image<std::uint8_t> texture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      q(x, y) = wall;
      grey(x, y) = static_cast<std::uint8_t>(100 + contrast * random.uniform());
      texture(x, y) = static_cast<std::uint8_t>(100 + contrast * random.uniform());
    }
  for (int y = rows; y < rows + 20; ++y)
    for (int x = 0; x < 20; ++x) q(box_begin + x, y) = box, grey(box_begin + x, y) = texture(x, y);
  CellFrame frame;
  frame.build(grey, q);
  return frame;
}

struct Case {
  Pinhole camera{{100, 100, 29.5, 19.5, width, height, 0.5}};
  DepthNoise noise;
  dot::InconsistencyTest<Pinhole, DepthNoise> test;
  dot::CellMotion motion;
  CellEvidence evidence;

  Case() {
    dot::DepthNoiseSettings settings;
    settings.source = dot::DepthSource::Stereo;
    noise = DepthNoise(settings, {400, 400, 0, 0, 4 * width, 4 * height, 0.5});
    test.prepare(camera);
  }
  /// The box has moved by some cells; the hypothesis says so, or another number of cells.
  void compare(int moved, double hypothesis, int contrast = 100) {
    const CellFrame now = scene(first + moved, contrast), before = scene(first, contrast);
    dot::Mask mask;
    dot::fill_mask(
        {0, 0, 4 * width, 4 * height}, [](int, int) { return true; }, mask);
    evidence.restart(mask, 4);
    const SE3d T = SE3d::translation(Vector3<double>(hypothesis / 100 / static_cast<double>(box), 0, 0));
    const CellComparison<Pinhole, DepthNoise> comparison{camera, noise, test, now, before, motion, 1};
    comparison(T, evidence);
  }
  /// Mean over the cells of a box that are compared.
  double mean(const Image<float>& sum, int x0, int x1) const {
    double total = 0, n = 0;
    for (int y = rows + 2; y < rows + 18; ++y)
      for (int x = x0; x < x1; ++x)
        if (evidence.references(x, y) > 0) total += static_cast<double>(sum(x, y)), n += 1;
    return n > 0 ? total / n : 0;
  }
};

TEST(CellEvidence, CoversTheBoxOfTheMask) {
  dot::Mask mask;
  dot::fill_mask(
      {9, 17, 10, 4}, [](int, int) { return true; }, mask);
  CellEvidence evidence;
  evidence.restart(mask, 4);
  EXPECT_EQ(evidence.x, 2);  // pixels 8 to 11
  EXPECT_EQ(evidence.y, 4);
  EXPECT_EQ(evidence.total.width(), 3);   // to pixel 18
  EXPECT_EQ(evidence.total.height(), 2);  // to pixel 20
  EXPECT_EQ(evidence.total(2, 1), 0);
  EXPECT_EQ(evidence.measured(2, 1), 0);
}

TEST(CellEvidence, ForWhatMoves) {
  Case c;
  c.compare(6, shift);
  EXPECT_GT(c.mean(c.evidence.total, first + 8, first + 24), 5);
  EXPECT_GT(c.mean(c.evidence.intensity, first + 8, first + 24), 5);
  // Its leading part is where the reference shows the wall.
  EXPECT_GT(c.mean(c.evidence.total, first + 22, first + 25), c.mean(c.evidence.intensity, first + 22, first + 25) + 5);
}

TEST(CellEvidence, AgainstWhatStands) {
  Case c;
  c.compare(6, shift);
  EXPECT_LT(c.mean(c.evidence.total, first + 30, first + 38), -5) << "the wall beside the box";
  c.compare(0, shift);
  EXPECT_LT(c.mean(c.evidence.total, first + 8, first + 18), -5) << "the box, which stands";
}

TEST(CellEvidence, NoneWithoutContrast) {
  Case c;
  c.compare(6, shift, 2);
  EXPECT_NEAR(c.mean(c.evidence.intensity, first + 8, first + 24), 0, 0.5);
}

TEST(CellEvidence, NoneWhereBothExplanationsAreTheSame) {
  Case c;
  c.compare(0, 0.5);  // half a cell
  EXPECT_EQ(c.mean(c.evidence.references, 0, width), 0);
  EXPECT_EQ(c.evidence.measured(first, rows), 1);
}

// What the box has uncovered was hidden before, so that the reference tells nothing of it.
TEST(CellEvidence, NoneOfWhatWasHidden) {
  Case c;
  c.compare(6, shift);
  for (int y = rows + 2; y < rows + 18; ++y)
    for (int x = first + 2; x < first + 5; ++x) EXPECT_EQ(c.evidence.references(x, y), 0) << x << ' ' << y;
}

TEST(CellEvidence, NothingIsReadOutsideOfTheImage) {
  Case c;
  dot::Mask mask;
  dot::fill_mask(
      {-8, -8, 4 * width + 16, 4 * height + 16}, [](int, int) { return true; }, mask);
  const CellFrame frame = scene(first);
  c.evidence.restart(mask, 4);
  const CellComparison<Pinhole, DepthNoise> comparison{c.camera, c.noise, c.test, frame, frame, c.motion, 1};
  comparison(SE3d::translation(Vector3<double>(0.5, 0, 0)), c.evidence);
  EXPECT_EQ(c.evidence.measured(0, 0), 0);
  EXPECT_EQ(c.evidence.measured(c.evidence.total.width() - 1, c.evidence.total.height() - 1), 0);
}

}  // namespace
