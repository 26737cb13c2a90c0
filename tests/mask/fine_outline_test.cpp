// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/fine_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"
#include "dot/mask/coarse_outline.hpp"

namespace {

using dot::Image;
using dot::ImageView;
using dot::Mask;
using dot::MaskTemplate;
using dot::SE3d;
using dot::Vector3;
using dot::WarpedMask;

constexpr int kWidth = 645, kHeight = 483, kLevels = 4;  // no multiples of the blocks
constexpr double kTolerance = 0.3;
const dot::Pinhole kCamera{{400, 400, 320, 240, kWidth, kHeight, 0}};

using Surface = std::function<double(int, int)>;  ///< inverse depth, 1/m
double flat(int, int) { return 0.2; }
double slanted(int x, int) { return 0.2 + 4e-4 * (x - 320); }

/// An ellipse with a slit, narrower than a block, and an antenna.
Mask shape(double x, double y, double a, double b) {
  const auto inside = [=](int u, int v) {
    const bool slit = std::abs(u - x) < 2 && v > y, antenna = std::abs(u - x) < 1 && v < y && v > y - 1.1 * b;
    return (std::hypot((u - x) / a, (v - y) / b) < 1 && !slit) || antenna;
  };
  Mask out;
  dot::fill_mask({0, 0, kWidth, kHeight}, inside, out);
  return out;
}

/// The mask warped exactly, and with the surface of a coarser level.
struct Case {
  MaskTemplate exact_template, coarse;
  WarpedMask exact, fine;

  Case(const Mask& mask, const Surface& surface, int level) {
    dot::DepthPyramid depth;
    const auto row = [&](int y, float* q) {
      for (int x = 0; x < kWidth; ++x) q[x] = static_cast<float>(surface(x, y));
    };
    depth.build(kWidth, kHeight, row, kLevels);
    dot::TemplateWorkspace workspace;
    EXPECT_TRUE(dot::make_template(mask, depth.levels[0].view(), kTolerance, workspace, exact_template));
    EXPECT_TRUE(dot::make_surface_template(level, mask, depth, kTolerance, workspace, coarse));
  }
  template <typename Camera = dot::Pinhole>
  void warp(const SE3d& T, ImageView<const float> measured = {}, const Camera& camera = kCamera) {
    dot::WarpWorkspace workspace;
    dot::warp(exact_template, T, camera, measured, kTolerance, workspace, exact);
    dot::FineOutline outline;
    outline.warp(exact_template.mask, coarse, T, camera, measured, kTolerance, workspace, fine);
  }
  /// Pixels of one mask alone.
  int difference() const { return exact.mask.area + fine.mask.area - 2 * dot::overlap(exact.mask, fine.mask); }
};

SE3d motion(double x, double y, double z, double turn) {
  return SE3d::translation(Vector3<double>(x, y, z)) *
         SE3d::exp((dot::Vector6<double>() << 0, 0, 0, 0, 0, turn).finished());
}

TEST(FineOutline, IsTheMaskItselfWithoutMotion) {
  for (const int level : {1, 2, 3}) {
    Case c(shape(330, 220, 200, 140), slanted, level);
    c.warp({});
    EXPECT_EQ(c.fine.mask.area, c.exact_template.mask.area) << level;
    EXPECT_EQ(dot::overlap(c.fine.mask, c.exact_template.mask), c.fine.mask.area) << level;
  }
}

// Beside the camera's axis, nearer, farther, half as large, turned.
TEST(FineOutline, IsWhereTheExactOneIs) {
  for (const Surface& surface : {Surface(flat), Surface(slanted)})
    for (const double size : {60., 200.})
      for (const SE3d& T : {motion(0.3, 0.1, 0, 0), motion(0, 0, -1, 0.05), motion(0, 0, 2, 0), motion(0, 0, 5, 0.3)}) {
        const Mask mask = shape(330, 220, size, 0.7 * size);
        Case c(mask, surface, 1);
        c.warp(T);
        const double rim = 4 * std::sqrt(1.0 * c.exact.mask.area);  // pixels; with slit and antenna it is longer
        EXPECT_LT(c.difference(), 0.12 * rim) << size << ' ' << T.t.transpose();
        EXPECT_EQ(c.fine.inside_area, c.fine.mask.area);
        double worst = 0;
        const auto [x, y, width, height] = c.fine.mask.box();
        for (int v = y; v < y + height; ++v)
          for (int u = x; u < x + width; ++u)
            if (c.fine.mask.at(u, v) && c.exact.mask.at(u, v)) {
              const double q = static_cast<double>(c.exact.inverse_depth(u - c.exact.mask.x, v - c.exact.mask.y));
              worst = std::max(worst, std::abs(static_cast<double>(c.fine.inverse_depth(u - x, v - y)) / q - 1));
            }
        EXPECT_LT(worst, 0.03);
      }
}

TEST(FineOutline, SeesThroughALens) {
  const dot::RadTan lens(kCamera.intrinsics(), {-0.2, 0.05, 1e-3, -1e-3, 0});
  Case c(shape(200, 160, 150, 100), slanted, 1);
  c.warp({}, {}, lens);
  EXPECT_EQ(c.fine.mask.area, c.exact_template.mask.area);
  for (const SE3d& T : {motion(0.6, 0.3, 0, 0), motion(0, 0, -1, 0.05)}) {
    c.warp(T, {}, lens);
    EXPECT_LT(c.difference(), 0.5 * std::sqrt(1.0 * c.exact.mask.area));
    Case pinhole(shape(200, 160, 150, 100), slanted, 1);
    pinhole.warp(T);
    EXPECT_GT(pinhole.fine.mask.area + c.fine.mask.area - 2 * dot::overlap(pinhole.fine.mask, c.fine.mask), 500);
  }
}

TEST(FineOutline, IsTrimmedAsTheExactOne) {
  Case c(shape(330, 220, 200, 140), flat, 1);
  Image<float> measured(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) measured(x, y) = x < 250 ? 0.5f : x < 350 ? 0.2f : x < 400 ? 0 : 0.1f;
  measured(300, 200) = std::numeric_limits<float>::infinity();
  c.warp(motion(0.1, 0, 0, 0), measured.view());
  EXPECT_EQ(c.difference(), 0);
  EXPECT_EQ(c.fine.inside_area, c.exact.inside_area);
  EXPECT_EQ(c.fine.confirmed_area, c.exact.confirmed_area);
  EXPECT_EQ(c.fine.occluded_area, c.exact.occluded_area);
  EXPECT_TRUE(c.fine.mask.at(375, 200)) << "not measured";
  EXPECT_FALSE(c.fine.mask.at(240, 200)) << "hidden";
  EXPECT_FALSE(c.fine.mask.at(450, 200)) << "gone";
}

// Where the last blocks of a level do not reach the border.
TEST(FineOutline, StaysInsideTheImage) {
  for (const int level : {1, 2, 3})
    for (const auto& [x, y] : {std::array<int, 2>{0, 0}, {kWidth, kHeight}, {kWidth, 200}, {300, kHeight}}) {
      Case c(shape(x, y, 150, 100), flat, level);
      c.warp(motion(0.3, 0.2, 0, 0));
      EXPECT_LT(c.difference(), 30) << level << ' ' << x << ' ' << y;
      const auto [left, top, width, height] = c.fine.mask.box();
      EXPECT_GE(std::min(left, top), 0);
      EXPECT_LE(left + width, kWidth);
      EXPECT_LE(top + height, kHeight);
      c.warp({});
      EXPECT_EQ(c.difference(), 0) << level << ' ' << x << ' ' << y;
    }
}

TEST(FineOutline, IsEmptyWhereNothingIsLeft) {
  Case c(shape(330, 220, 100, 70), flat, 1);
  for (const SE3d& T : {motion(0, 0, -6, 0), motion(100, 0, 0, 0)}) {
    c.warp({}), c.warp(T);
    EXPECT_TRUE(c.fine.mask.empty());
    EXPECT_EQ(c.fine.inside_area, 0);
  }
}

}  // namespace
