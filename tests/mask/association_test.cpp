// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/association.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/iou.hpp"

namespace {

using dot::Mask;
using dot::test::iou;

Mask rectangle(int x, int y, int width, int height) {
  Mask mask;
  dot::fill_mask(
      {x, y, width, height}, [](int, int) { return true; }, mask);
  return mask;
}

std::vector<int> associate(const std::vector<Mask>& predicted, const std::vector<Mask>& observed,
                           const dot::MaskSettings& settings = {}) {
  std::vector<dot::Outline> p, o;
  for (const Mask& mask : predicted) p.push_back({&mask, 0});
  for (const Mask& mask : observed) o.push_back({&mask, 0});
  dot::SparseAssignWorkspace workspace;
  return dot::associate(p, o, settings, workspace);
}

using Partners = std::vector<int>;

TEST(Association, FollowsMasksInAnyOrder) {
  const std::vector<Mask> predicted{rectangle(10, 10, 20, 10), rectangle(50, 10, 20, 10), rectangle(90, 10, 20, 10)};
  const std::vector<Mask> observed{rectangle(93, 11, 20, 10), rectangle(12, 9, 20, 10), rectangle(52, 10, 18, 10)};
  EXPECT_EQ(associate(predicted, observed), (Partners{2, 0, 1}));
}

TEST(Association, LeavesStrangersAlone) {
  EXPECT_EQ(associate({rectangle(0, 0, 20, 10)}, {rectangle(60, 0, 20, 10)}), (Partners{-1}));
  EXPECT_EQ(associate({}, {rectangle(60, 0, 20, 10)}), (Partners{-1}));
  EXPECT_TRUE(associate({rectangle(0, 0, 20, 10)}, {}).empty());
  EXPECT_EQ(associate({Mask{}}, {Mask{}}), (Partners{-1}));
}

TEST(Association, NeedsEnoughOverlap) {
  dot::MaskSettings settings;
  settings.min_iou = 0.2;
  settings.min_containment = 0.7;
  // Overlap k of 20 columns each: IoU k / (40 - k), containment k / 20.
  EXPECT_EQ(associate({rectangle(0, 0, 20, 10)}, {rectangle(14, 0, 20, 10)}, settings), (Partners{-1}));
  EXPECT_EQ(associate({rectangle(0, 0, 20, 10)}, {rectangle(13, 0, 20, 10)}, settings), (Partners{0}));
  settings.min_iou = 0.25;
  EXPECT_EQ(associate({rectangle(0, 0, 20, 10)}, {rectangle(13, 0, 20, 10)}, settings), (Partners{-1}));
}

// A van that covers a parked car is no larger part of it, unless the car is as long as the way between them.
TEST(Association, WhatPassesBeforeAnObjectIsNotIt) {
  const Mask car = rectangle(20, 10, 20, 10), van = rectangle(0, 0, 50, 22);
  ASSERT_LT(iou(car, van), dot::MaskSettings{}.min_iou);
  dot::SparseAssignWorkspace workspace;
  const auto partner = [&](double z_car, double size, double z_van) {
    return dot::associate({{&car, 1 / z_car, size}}, {{&van, 1 / z_van, 0}}, {}, workspace)[0];
  };
  EXPECT_EQ(partner(8.5, 1.3, 8), 0);
  EXPECT_EQ(partner(8.5, 1.3, 4.5), -1);
  EXPECT_EQ(partner(8.5, 1.3, 13), -1);
  EXPECT_EQ(partner(8.5, 5, 4.5), 0) << "a long one";
  EXPECT_EQ(partner(40, 1.3, 30), 0) << "a distant one, whose depth is uncertain";
}

TEST(Association, AcceptsASmallPartByContainment) {
  dot::MaskSettings settings;
  const Mask whole = rectangle(0, 0, 60, 20), part = rectangle(40, 5, 15, 10);
  ASSERT_LT(iou(whole, part), settings.min_iou);
  EXPECT_EQ(associate({whole}, {part}, settings), (Partners{0}));
  EXPECT_EQ(associate({part}, {whole}, settings), (Partners{0}));
  settings.min_containment = 1.01;
  EXPECT_EQ(associate({whole}, {part}, settings), (Partners{-1}));
}

// What a false detection left behind is not the car that drives over it.
TEST(Association, ASpeckUnderALargeMaskIsNotContinuedByIt) {
  const Mask car = rectangle(0, 0, 60, 20), eleventh = rectangle(40, 5, 11, 10), ninth = rectangle(40, 5, 14, 10);
  ASSERT_LT(iou(car, eleventh), 0.1);
  ASSERT_GT(iou(car, ninth), 0.1);
  EXPECT_EQ(associate({eleventh}, {car}), (Partners{-1}));
  EXPECT_EQ(associate({ninth}, {car}), (Partners{0}));
}

// A mover comes out beside a parked car far behind it: the small far outline lies within the large near one.
TEST(Association, WhatPassesBehindIsAnotherThing) {
  const Mask near = rectangle(0, 0, 60, 20), far = rectangle(40, 5, 15, 10);
  const auto partner = [](const Mask& a, double qa, const Mask& b, double qb) {
    dot::SparseAssignWorkspace workspace;
    return dot::associate({{&a, qa}}, {{&b, qb}}, {}, workspace)[0];
  };
  EXPECT_EQ(partner(far, 0.02, near, 0.1), -1);
  EXPECT_EQ(partner(near, 0.1, far, 0.02), -1);
  EXPECT_EQ(partner(far, 0.06, near, 0.1), 0) << "as far as depth under ragged masks may differ";
  EXPECT_EQ(partner(far, 0, near, 0.1), 0) << "not measured";
  EXPECT_EQ(partner(far, 0.02, near, 0), 0);
  const Mask beside = rectangle(5, 0, 60, 20);
  ASSERT_GT(iou(near, beside), 0.8);
  EXPECT_EQ(partner(near, 0.1, beside, 0.02), 0) << "the overlap is too good to be chance";
}

TEST(Association, SplitMaskKeepsTheLargerPart) {
  const std::vector<Mask> predicted{rectangle(10, 10, 50, 20)};
  const std::vector<Mask> observed{rectangle(10, 10, 18, 20), rectangle(30, 10, 30, 20)};
  EXPECT_EQ(associate(predicted, observed), (Partners{-1, 0}));
}

TEST(Association, MergedMaskGoesToTheLargerTrack) {
  const std::vector<Mask> predicted{rectangle(10, 10, 18, 20), rectangle(30, 10, 30, 20)};
  const std::vector<Mask> observed{rectangle(10, 10, 50, 20)};
  EXPECT_EQ(associate(predicted, observed), (Partners{1}));
}

TEST(Association, VanishedAndReappearingMasksDisturbNoOther) {
  const std::vector<Mask> tracks{rectangle(10, 10, 20, 10), rectangle(50, 10, 20, 10), rectangle(90, 10, 20, 10)};
  EXPECT_EQ(associate(tracks, {tracks[0], tracks[2]}), (Partners{0, 2}));
  EXPECT_EQ(associate(tracks, {tracks[0], rectangle(55, 12, 20, 10), tracks[2]}), (Partners{0, 1, 2}));
}

TEST(Association, TakesTheBestSumNotTheBestPair) {
  // The first observation overlaps both tracks, the second one only the first track.
  const std::vector<Mask> predicted{rectangle(0, 0, 40, 10), rectangle(16, 0, 40, 10)};
  const std::vector<Mask> observed{rectangle(7, 0, 40, 10), rectangle(-0, 0, 36, 10)};
  ASSERT_GT(iou(observed[0], predicted[0]), iou(observed[0], predicted[1]));
  EXPECT_EQ(associate(predicted, observed), (Partners{1, 0}));
}

TEST(Association, DoesNotBreakAGoodPairForTwoPoorOnes) {
  // Pairing both observations is possible, but only by giving up the good pair.
  const std::vector<Mask> predicted{rectangle(20, 0, 40, 10), rectangle(46, 0, 40, 10)};
  const std::vector<Mask> observed{rectangle(21, 0, 40, 10), rectangle(0, 0, 35, 10)};
  const dot::MaskSettings settings;
  ASSERT_GT(iou(observed[0], predicted[0]), 0.9);
  ASSERT_GT(iou(observed[0], predicted[1]), settings.min_iou);
  ASSERT_GT(iou(observed[1], predicted[0]), settings.min_iou);
  ASSERT_LT(iou(observed[1], predicted[1]), settings.min_iou);
  EXPECT_EQ(associate(predicted, observed), (Partners{0, -1}));
}

}  // namespace
