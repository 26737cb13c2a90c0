// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/coarse_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/tracks/outline.hpp"
#include "support/iou.hpp"
#include "support/random.hpp"

namespace {

using dot::Mask;
using dot::MaskTemplate;
using dot::SE3d;
using dot::TrackedOutline;
using dot::WarpedMask;
using dot::test::iou;
using Vector3d = dot::Vector3<double>;

constexpr int kWidth = 645, kHeight = 483, kLevels = 4;  // no multiples of the coarse pixels
constexpr double kTolerance = 0.3;
constexpr float kObject = 0.1f, kWall = 0.02f, kNear = 0.5f;  // 1/m
const dot::Pinhole kCamera{{400, 400, 320, 240, kWidth, kHeight, 0}};

Mask ellipse(double x, double y, double a, double b) {
  Mask out;
  dot::fill_mask(
      {0, 0, kWidth, kHeight}, [=](int u, int v) { return std::hypot((u - x) / a, (v - y) / b) < 1; }, out);
  return out;
}

/// A frame with these objects before a wall, a later one before an earlier one.
dot::FramePtr frame_of(std::initializer_list<std::pair<Mask, float>> objects) {
  auto out = std::make_shared<dot::FrameData>();
  const auto row = [&](int y, float* q) {
    std::fill_n(q, kWidth, kWall);
    for (const auto& [mask, inverse_depth] : objects)
      for (int x = 0; x < kWidth; ++x) q[x] = mask.at(x, y) ? inverse_depth : q[x];
  };
  out->depth.build(kWidth, kHeight, row, kLevels);
  return out;
}

TEST(CoarseOutline, LevelFollowsTheArea) {
  EXPECT_EQ(dot::coarse_level(0, kLevels), 0);
  EXPECT_EQ(dot::coarse_level(1999, kLevels), 0);
  EXPECT_EQ(dot::coarse_level(2000, kLevels), 1);
  EXPECT_EQ(dot::coarse_level(8000, kLevels), 2);
  EXPECT_EQ(dot::coarse_level(32000, kLevels), 3);
  EXPECT_EQ(dot::coarse_level(10000000, 6), 3);
  EXPECT_EQ(dot::coarse_level(10000000, 2), 1);
  EXPECT_EQ(dot::coarse_level(10000000, 1), 0);
}

TEST(CoarseOutline, SmallOrUnmeasuredMasksHaveNone) {
  dot::TemplateWorkspace workspace;
  MaskTemplate out;
  const Mask small = ellipse(300, 200, 15, 15), large = ellipse(300, 200, 90, 60);
  EXPECT_FALSE(dot::make_coarse_template(small, frame_of({{small, kObject}})->depth, kTolerance, workspace, out));
  EXPECT_TRUE(dot::make_coarse_template(large, frame_of({{large, kObject}})->depth, kTolerance, workspace, out));
  EXPECT_EQ(out.level, 2);
  const dot::FramePtr blind = frame_of({{large, 0.f}});
  EXPECT_FALSE(dot::make_coarse_template(large, blind->depth, kTolerance, workspace, out));
  EXPECT_EQ(out.level, 0);
  EXPECT_TRUE(out.mask.empty());
}

TEST(CoarseOutline, EnlargedPixelsBecomeSquares) {
  WarpedMask coarse, fine;
  coarse.mask.x = 3, coarse.mask.y = 5, coarse.mask.area = 2;
  coarse.mask.pixels.resize(2, 2);
  coarse.mask.pixels.fill(0);
  coarse.mask.pixels(0, 0) = coarse.mask.pixels(1, 1) = 255;
  coarse.inverse_depth.resize(2, 2);
  coarse.inverse_depth.fill(0);
  coarse.inverse_depth(0, 0) = 0.1f, coarse.inverse_depth(1, 1) = 0.2f;
  coarse.inside_area = 2, coarse.occluded_area = 1;
  dot::enlarge_surface(coarse, 2, fine);
  EXPECT_EQ(fine.mask.box(), (std::array<int, 4>{12, 20, 8, 8}));
  EXPECT_EQ(fine.mask.area, 32);
  EXPECT_EQ(fine.inside_area, 32);
  EXPECT_EQ(fine.occluded_area, 16);
  for (int v = 0; v < 8; ++v)
    for (int u = 0; u < 8; ++u) {
      const bool set = u / 4 == v / 4;
      EXPECT_EQ(fine.mask.pixels(u, v), set ? 255 : 0);
      EXPECT_EQ(fine.inverse_depth(u, v), !set ? 0.f : u < 4 ? 0.1f : 0.2f);
    }
}

/// Approaching, receding, turned, partly outside the image: the coarse prediction lies where the exact one lies.
TEST(CoarseOutline, PredictsWhereTheExactOneIs) {
  for (const double size : {32., 60., 150.}) {
    const Mask mask = ellipse(340, 230, size, 0.7 * size);
    const dot::FramePtr frame = frame_of({{mask, kObject}});
    dot::OutlineWorkspace workspace;
    TrackedOutline outline;
    outline.set_shape(mask, {}, frame, 0.01, kCamera, {}, workspace);
    ASSERT_GT(outline.coarse.level, 0);
    for (const Vector3d& t :
         {Vector3d(0, 0, 0), Vector3d(1.5, 0.2, 0), Vector3d(0, 0, -3), Vector3d(0, 0, 4), Vector3d(-8, 0, 0)})
      for (const double turn : {0., 0.05}) {
        const SE3d T = SE3d::translation(t) * SE3d::exp((dot::Vector6<double>() << 0, 0, 0, 0, 0, turn).finished());
        const dot::DepthPyramid nothing = frame_of({})->depth;
        TrackedOutline predicted = outline, exact = outline;
        dot::MaskSettings untrimmed;
        untrimmed.depth_tolerance = 1e6;
        predicted.predict_by(T, nothing, kCamera, untrimmed, workspace);
        exact.warp_by(T, nothing.levels[0], kCamera, untrimmed, workspace);
        EXPECT_TRUE(predicted.is_coarse);
        EXPECT_FALSE(exact.is_coarse);
        EXPECT_TRUE(predicted.warped.inverse_depth.empty());
        EXPECT_GT(iou(predicted.warped.mask, exact.warped.mask), 0.9) << size << ' ' << t.transpose();
      }
  }
}

/// The depth of a large shape is put off until it is needed, and is then the same as if it had been made at once.
TEST(CoarseOutline, TheExactShapeIsMadeWhenItIsNeeded) {
  const Mask mask = ellipse(340, 230, 100, 70);
  const dot::FramePtr frame = frame_of({{mask, kObject}}), next = frame_of({{ellipse(360, 230, 100, 70), kObject}});
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  outline.set_shape(mask, {}, frame, 0.01, kCamera, {}, workspace);
  EXPECT_EQ(outline.shape_frame, frame);
  EXPECT_NEAR(outline.shape.median, kObject, 1e-6);

  const SE3d T = SE3d::translation(Vector3d(0.5, 0, 0));
  outline.warp_by(T, next->inverse_depth(), kCamera, {}, workspace);
  EXPECT_EQ(outline.shape_frame, nullptr);  // the old frame is not kept alive
  MaskTemplate at_once;
  WarpedMask expected;
  ASSERT_TRUE(dot::make_template(mask, frame->inverse_depth().view(), kTolerance, at_once));
  dot::warp(at_once, T, kCamera, next->inverse_depth().view(), kTolerance, workspace.warp, expected);
  EXPECT_EQ(outline.warped.mask.area, expected.mask.area);
  EXPECT_EQ(dot::overlap(outline.warped.mask, expected.mask), expected.mask.area);
  EXPECT_EQ(outline.warped.confirmed_area, expected.confirmed_area);
}

/// A frame of a slanted surface, of which a share of the pixels is measured.
dot::FramePtr slanted_frame(double share) {
  auto out = std::make_shared<dot::FrameData>();
  dot::test::Random random(1);
  const auto row = [&](int, float* q) {
    for (int x = 0; x < kWidth; ++x)
      q[x] = random.uniform() < share ? kObject + 4e-4f * static_cast<float>(x - 300) : 0;
  };
  out->depth.build(kWidth, kHeight, row, kLevels);
  return out;
}

/// On level 1 for the largest, which costs a few pixels of the outline; on level 0 for those that are less large.
TEST(CoarseOutline, TheExactOutlineHasAFineSurface) {
  const SE3d T = SE3d::translation(Vector3d(1, 0.3, 0));
  for (const auto& [size, level, most] : {std::tuple{35., 0, 0}, std::tuple{150., 1, 150}}) {
    const Mask mask = ellipse(300, 200, size, 0.7 * size);
    const dot::FramePtr frame = slanted_frame(1);
    dot::OutlineWorkspace workspace;
    TrackedOutline outline;
    outline.set_shape(mask, {}, frame, 0.01, kCamera, {}, workspace);
    EXPECT_GT(outline.coarse.level, level);
    outline.warp_by(T, dot::Image<float>(kWidth, kHeight), kCamera, {}, workspace);
    EXPECT_EQ(outline.surface.level, level);
    MaskTemplate at_once;
    WarpedMask exact;
    ASSERT_TRUE(dot::make_template(mask, frame->inverse_depth().view(), kTolerance, at_once));
    dot::warp(at_once, T, kCamera, {}, kTolerance, workspace.warp, exact);
    const Mask& fine = outline.warped.mask;
    EXPECT_LE(fine.area + exact.mask.area - 2 * dot::overlap(fine, exact.mask), most);
  }
}

TEST(CoarseOutline, TheSurfaceIsOfTheLastMask) {
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  for (const double size : {150., 35., 60., 150.})
    for (const float q : {kObject, 2 * kObject}) {
      const Mask mask = ellipse(300, 200, size, size);
      outline.set_shape(mask, {}, frame_of({{mask, q}}), 0.01, kCamera, {}, workspace);
      outline.warp_by({}, dot::Image<float>(kWidth, kHeight), kCamera, {}, workspace);
      EXPECT_EQ(dot::overlap(outline.warped.mask, mask), mask.area);
      EXPECT_EQ(outline.warped.mask.area, mask.area);
      EXPECT_NEAR(outline.warped.inverse_depth(mask.width() / 2, mask.height() / 2), q, 1e-6);
    }
}

/// Depth may be too sparse on level 1 while coarser pixels have some.
TEST(CoarseOutline, TheExactOutlineHasACoarseSurfaceIfThereIsNoOther) {
  const Mask mask = ellipse(300, 200, 150, 105);
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  outline.set_shape(mask, {}, slanted_frame(0.1), 0.01, kCamera, {}, workspace);
  ASSERT_GT(outline.coarse.level, 1);
  outline.warp_by({}, dot::Image<float>(kWidth, kHeight), kCamera, {}, workspace);
  EXPECT_EQ(outline.surface.level, outline.coarse.level);
  EXPECT_EQ(dot::overlap(outline.warped.mask, mask), mask.area);
}

/// What is cut off by the right and the lower border, where a level may have no pixels any more.
TEST(CoarseOutline, StaysInsideTheImage) {
  dot::OutlineWorkspace workspace;
  for (const Mask& mask : {ellipse(kWidth, kHeight, 150, 100), ellipse(kWidth, 200, 6, 150),
                           ellipse(300, kHeight, 400, 5), ellipse(0, 0, 200, 100)}) {
    const dot::FramePtr frame = frame_of({{mask, kObject}});
    TrackedOutline outline;
    outline.set_shape(mask, {}, frame, 0.01, kCamera, {}, workspace);
    outline.predict_by(SE3d::translation(Vector3d(0.2, 0.2, 0)), frame->depth, kCamera, {}, workspace);
    const auto [x, y, width, height] = outline.warped.mask.box();
    EXPECT_GE(std::min(x, y), 0);
    EXPECT_LE(x + width, kWidth);
    EXPECT_LE(y + height, kHeight);
    outline.predict_by({}, frame->depth, kCamera, {}, workspace);
    EXPECT_GT(iou(outline.warped.mask, mask), 0.5) << mask.area;
  }
}

TEST(CoarseOutline, GivesItsSurfaceOnRequest) {
  const Mask mask = ellipse(340, 230, 150, 105);
  const dot::FramePtr frame = frame_of({{mask, kObject}});
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  outline.set_shape(mask, {}, frame, 0.01, kCamera, {}, workspace);
  outline.predict_by({}, frame->depth, kCamera, {}, workspace, true);
  ASSERT_TRUE(outline.is_coarse);
  const dot::WarpedMask& warped = outline.warped;
  ASSERT_EQ(warped.inverse_depth.width(), warped.mask.width());
  for (int y = 0; y < warped.mask.height(); ++y)
    for (int x = 0; x < warped.mask.width(); ++x)
      if (warped.mask.pixels(x, y)) {
        ASSERT_NEAR(warped.inverse_depth(x, y), kObject, 0.05 * kObject);
      }
}

/// Beside an object without depth, blocks at its border have that of what is behind it.
TEST(CoarseOutline, NeedsDepthInside) {
  const Mask mask = ellipse(340, 230, 100, 70);
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  outline.set_shape(mask, {}, frame_of({{mask, 0.f}}), 0.01, kCamera, {}, workspace);
  EXPECT_EQ(outline.coarse.level, 0);
  EXPECT_FALSE(outline.shape.measured);
}

/// A coarse part that hides nothing leaves the fine ones as they are.
TEST(CoarseOutline, HiddenPixelsKeepTheirLevel) {
  const Mask whole = ellipse(300, 200, 30, 30);
  WarpedMask fine, coarse;
  fine.mask = whole;
  fine.inverse_depth.resize(whole.width(), whole.height());
  fine.inverse_depth.fill(kObject);
  dot::fill_mask(
      {10, 10, 5, 5}, [](int, int) { return true; }, coarse.mask);
  coarse.inverse_depth.resize(5, 5);
  coarse.inverse_depth.fill(kNear);
  const dot::FramePtr nearer = frame_of({{whole, kNear}});
  dot::HiddenPart part;
  part.add(fine, nearer->inverse_depth().view(), kTolerance, {});
  part.add(coarse, nearer->depth.levels[3].view(), kTolerance, {}, 3);
  MaskTemplate hidden;
  part.make_template(hidden);
  EXPECT_EQ(hidden.level, 0);
  EXPECT_EQ(hidden.mask.area, whole.area);
}

/// What hides a part of a large object is found on the coarse level, too.
TEST(CoarseOutline, FindsTheHiddenPart) {
  const Mask whole = ellipse(340, 230, 100, 70), post = ellipse(380, 230, 25, 200);
  const dot::FramePtr first = frame_of({{whole, kObject}}), second = frame_of({{whole, kObject}, {post, kNear}});
  Mask shown;
  dot::fill_mask(
      whole.box(), [&](int u, int v) { return whole.at(u, v) && !post.at(u, v); }, shown);
  dot::OutlineWorkspace workspace;
  TrackedOutline outline;
  outline.set_shape(whole, {}, first, 0.01, kCamera, {}, workspace);
  EXPECT_TRUE(outline.hidden_part.mask.empty());
  outline.predict_by({}, second->depth, kCamera, {}, workspace);
  EXPECT_NEAR(outline.warped.occluded_area, dot::overlap(whole, post), 0.15 * dot::overlap(whole, post));
  outline.set_shape(shown, {}, second, 0.01, kCamera, {}, workspace);
  ASSERT_GT(outline.hidden_part.level, 0);

  WarpedMask moved, hidden;
  dot::warp_on_level(outline.hidden_part, {}, kCamera, nullptr, 0, workspace.warp, moved);
  dot::enlarge_surface(moved, outline.hidden_part.level, hidden);
  Mask expected;
  dot::fill_mask(
      whole.box(), [&](int u, int v) { return whole.at(u, v) && post.at(u, v); }, expected);
  EXPECT_GT(iou(hidden.mask, expected), 0.75);
  EXPECT_LT(hidden.mask.area - dot::overlap(hidden.mask, whole), 0.05 * whole.area);
}

}  // namespace
