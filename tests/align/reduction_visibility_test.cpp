// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "dot/align/reduction.hpp"
#include "dot/camera/pinhole.hpp"

/// @file
/// Which points a reduction sees: in front, inside the image, not hidden by what the depth or a nearer object shows.

namespace {

using dot::AlignState;
using dot::DepthTerm;
using dot::Image;
using dot::PointSet;
using dot::SE3d;
using dot::SerialReduction;
using dot::Vector3;

const dot::Pinhole camera({100, 100, 63.5, 47.5, 128, 96, 0});

PointSet point(float u, float v, float q) {
  PointSet points;
  const auto ray = camera.unproject(dot::Vector2<float>(u, v));
  points.push(u, v, ray.x(), ray.y(), q, 0);
  points.levels = 2;
  points.intensity[0] = points.intensity[1] = {100};
  return points;
}

struct PointResidual {
  bool seen, has_depth, occluded;
  float r_depth;
};

PointResidual residual(const PointSet& points, const SE3d& T, const DepthTerm& depth, int level = 0) {
  Image<std::uint8_t> grey(128 >> level, 96 >> level);
  grey.fill(100);
  dot::PointResiduals out;
  SerialReduction::residuals(points, level, camera.at_level(level), grey, AlignState{T, 1, 0}, {}, depth, out);
  return {out.seen(0), out.has_depth(0), out.occluded(0), out.r_depth[0]};
}

TEST(ReductionVisibility, EndsBeforeTheImageDoes) {
  const SE3d still;
  EXPECT_TRUE(residual(point(1.001f, 1.001f, 1), still, {}).seen);  // at 1 it depends on the rounding
  EXPECT_FALSE(residual(point(0.9f, 20, 1), still, {}).seen);
  EXPECT_FALSE(residual(point(20, 0.9f, 1), still, {}).seen);
  EXPECT_TRUE(residual(point(124, 92, 1), still, {}).seen);
  EXPECT_FALSE(residual(point(126.5f, 20, 1), still, {}).seen);
  EXPECT_FALSE(residual(point(20, 94.5f, 1), still, {}).seen);
  // 13 px to the right of the 60th pixel, and out of the image.
  EXPECT_TRUE(residual(point(60, 40, 0.5f), SE3d::translation({0.26, 0, 0}), {}).seen);
  EXPECT_FALSE(residual(point(60, 40, 0.5f), SE3d::translation({1.4, 0, 0}), {}).seen);
}

TEST(ReductionVisibility, NeedsThePointInFront) {
  EXPECT_TRUE(residual(point(60, 40, 0.5f), SE3d::translation({0, 0, -1.5}), {}).seen);
  EXPECT_FALSE(residual(point(60, 40, 0.5f), SE3d::translation({0, 0, -2.5}), {}).seen);
  EXPECT_FALSE(residual(point(60, 40, 0.5f), SE3d::translation({0, 0, -2}), {}).seen);
}

TEST(ReductionVisibility, ANearerSurfaceHides) {
  Image<float> measured(128, 96);
  DepthTerm depth;
  depth.inverse_depth = measured.view();
  depth.sigma = 0.001f;
  depth.occlusion_relative = 0.15f;
  depth.occlusion_sigmas = 6;
  const auto at = [&](float q) {
    measured.fill(q);
    return residual(point(60, 40, 0.5f), SE3d{}, depth);
  };
  EXPECT_TRUE(at(0.5f).seen);
  EXPECT_TRUE(at(0.57f).seen);  // nearer by 14 %
  const PointResidual hidden = at(0.58f);
  EXPECT_FALSE(hidden.seen);
  EXPECT_TRUE(hidden.occluded);
  const PointResidual behind = at(0.3f);  // a farther surface does not hide; it disagrees
  EXPECT_TRUE(behind.seen);
  EXPECT_TRUE(behind.has_depth);
  EXPECT_NEAR(behind.r_depth, -0.2, 1e-6);
  const PointResidual unknown = at(0);
  EXPECT_TRUE(unknown.seen);
  EXPECT_FALSE(unknown.has_depth);
  depth.sigma = 0.05f;  // 0.3 within the noise
  EXPECT_TRUE(at(0.78f).seen);
  EXPECT_TRUE(at(0.82f).occluded);
}

TEST(ReductionVisibility, ANearerObjectHides) {
  Image<float> measured(128, 96);
  measured.fill(0);
  Image<std::uint8_t> object(128, 96);
  object.fill(0);
  DepthTerm depth;
  depth.inverse_depth = measured.view();
  depth.occluders = object.view();
  object(61, 40) = 255;
  EXPECT_TRUE(residual(point(60, 40, 0.5f), SE3d{}, depth).seen);
  object(60, 40) = 255;
  EXPECT_TRUE(residual(point(60, 40, 0.5f), SE3d{}, depth).occluded);
}

TEST(ReductionVisibility, DepthIsReadAtThePixelOfLevelZero) {
  Image<float> measured(128, 96);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x) measured(x, y) = 0.1f + 1e-4f * static_cast<float>(x) + 1e-3f * static_cast<float>(y);
  DepthTerm depth;
  depth.inverse_depth = measured.view();
  depth.occlusion_sigmas = 1e6f;
  depth.sigma = 1;
  for (const int level : {0, 1})
    for (const int u : {20, 21, 60, 61})
      for (const int v : {30, 31, 50, 51}) {
        const PointResidual r =
            residual(point(static_cast<float>(u), static_cast<float>(v), 0.5f), SE3d{}, depth, level);
        ASSERT_TRUE(r.has_depth);
        EXPECT_NEAR(r.r_depth + 0.5f, measured(u, v), 1e-6) << level << ": " << u << ", " << v;
      }
}

}  // namespace
