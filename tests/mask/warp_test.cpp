// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/warp.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"
#include "support/iou.hpp"

namespace {

using dot::Image;
using dot::ImageView;
using dot::Mask;
using dot::MaskTemplate;
using dot::SE3d;
using dot::WarpedMask;
using dot::test::iou;

constexpr int kWidth = 640, kHeight = 480;
constexpr double kTolerance = 0.3;
const dot::Intrinsics kIntrinsics{400, 400, 320, 240, kWidth, kHeight, 0};

/// An ellipse in the image; `grown` pixels wider on all sides.
struct Ellipse {
  double x, y, a, b;
  bool holds(double u, double v, double grown = 0) const {
    const double dx = (u - x) / (a + grown), dy = (v - y) / (b + grown);
    return dx * dx + dy * dy < 1;
  }
};

/// A template without depth noise: pixels for which `set(u, v)` holds, with inverse depth `depth(u, v)`.
template <typename Set, typename Depth>
MaskTemplate make(const Set& set, const Depth& depth) {
  MaskTemplate out;
  dot::fill_mask({0, 0, kWidth, kHeight}, set, out.mask);
  out.inverse_depth.resize(out.mask.width(), out.mask.height());
  for (int v = 0; v < out.mask.height(); ++v)
    for (int u = 0; u < out.mask.width(); ++u)
      out.inverse_depth(u, v) =
          out.mask.pixels(u, v) ? static_cast<float>(depth(out.mask.x + u, out.mask.y + v)) : 0.0f;
  return out;
}

template <typename Camera>
WarpedMask warp_through(const Camera& camera, const MaskTemplate& source, const SE3d& T,
                        ImageView<const float> measured = {}) {
  dot::WarpWorkspace workspace;
  WarpedMask out;
  dot::warp(source, T, camera, measured, kTolerance, workspace, out);
  return out;
}

WarpedMask warp(const MaskTemplate& source, const SE3d& T, ImageView<const float> measured = {}) {
  return warp_through(dot::Pinhole(kIntrinsics), source, T, measured);
}

SE3d motion(double x, double y, double z, double rx = 0, double ry = 0, double rz = 0) {
  SE3d T;
  T.R = dot::so3::exp(dot::Vector3<double>(rx, ry, rz));
  T.t = {x, y, z};
  return T;
}

/// Where a point of the current image came from, for an object whose surface is the template camera's plane
/// n X = 1 (1/q = 1 / (n ray)).
dot::Vector2<double> source_of(double u, double v, const SE3d& T, const dot::Vector3<double>& n) {
  const dot::Pinhole camera(kIntrinsics);
  const dot::Vector3<double> ray = T.R.transpose() * camera.unproject(dot::Vector2<double>(u, v));
  const dot::Vector3<double> origin = -(T.R.transpose() * T.t);
  const double depth = (1 - n.dot(origin)) / n.dot(ray);
  return camera.project(dot::Vector3<double>(origin + depth * ray));
}

/// Compares a warped mask with the outline carried over analytically: every pixel whose source lies a template pixel
/// inside the outline must be set, none whose source lies a pixel outside, and IoU and predicted depth must fit.
void expect_outline(const WarpedMask& found, const Ellipse& outline, const SE3d& T, const dot::Vector3<double>& n) {
  const dot::Pinhole camera(kIntrinsics);
  int both = 0, any = 0, cracks = 0, strays = 0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const dot::Vector2<double> p = source_of(u, v, T, n);
      const bool expected = outline.holds(p.x(), p.y()), set = found.mask.at(u, v);
      both += expected && set;
      any += expected || set;
      cracks += outline.holds(p.x(), p.y(), -1) && !set;
      strays += set && !outline.holds(p.x(), p.y(), 1);
      if (!set) continue;
      const double z_template = 1 / n.dot(camera.unproject(p));
      const double z = (T * dot::Vector3<double>(camera.unproject(p) * z_template)).z();
      ASSERT_NEAR(found.inverse_depth(u - found.mask.x, v - found.mask.y) * z, 1, 0.02) << u << ' ' << v;
    }
  }
  EXPECT_EQ(cracks, 0);
  EXPECT_EQ(strays, 0);
  EXPECT_GE(static_cast<double>(both) / any, 0.98);
}

/// The same for a plane n X = 1 seen through an ellipse.
WarpedMask check_plane(const Ellipse& outline, const SE3d& T, const dot::Vector3<double>& n) {
  const dot::Pinhole camera(kIntrinsics);
  const MaskTemplate source = make([&](int u, int v) { return outline.holds(u, v); },
                                   [&](int u, int v) { return n.dot(camera.unproject(dot::Vector2<double>(u, v))); });
  const WarpedMask found = warp(source, T);
  expect_outline(found, outline, T, n);
  return found;
}

const dot::Vector3<double> kFacing(0, 0, 0.1);          // 10 m away
const dot::Vector3<double> kSlanted(0.06, -0.02, 0.1);  // about 32 degrees

/// An outline with all that is hard to keep: a hole, a line and a point of one pixel, a comb.
bool ragged(int u, int v) {
  if (Ellipse{300, 200, 60, 40}.holds(u, v)) return !Ellipse{290, 205, 9, 6}.holds(u, v);
  if (u >= 380 && u < 400 && v >= 180 && v < 220) return u % 2 == 0;
  return (u == 410 && v == 200) || (v == 150 && u > 250 && u < 330);
}

void expect_same(const WarpedMask& found, const Mask& expected, int dx, int dy) {
  EXPECT_EQ(found.mask.area, expected.area);
  EXPECT_EQ(found.mask.box(),
            (std::array<int, 4>{expected.x + dx, expected.y + dy, expected.width(), expected.height()}));
  for (int v = expected.y; v < expected.y + expected.height(); ++v)
    for (int u = expected.x; u < expected.x + expected.width(); ++u)
      ASSERT_EQ(found.mask.at(u + dx, v + dy), expected.at(u, v)) << u << ' ' << v;
}

TEST(Warp, IdentityReproducesTheMask) {
  const MaskTemplate source = make(ragged, [](int u, int v) { return 0.1 + 1e-4 * u - 5e-5 * v; });
  const WarpedMask found = warp(source, SE3d());
  expect_same(found, source.mask, 0, 0);
  EXPECT_EQ(found.inside_area, source.mask.area);
  for (int v = 0; v < source.mask.height(); ++v)
    for (int u = 0; u < source.mask.width(); ++u)
      ASSERT_NEAR(found.inverse_depth(u, v), source.inverse_depth(u, v), 3e-4f) << "a cell may reach its neighbour";
}

TEST(Warp, IdentityReproducesTheMaskThroughALens) {
  const dot::RadTan camera(kIntrinsics, {-0.2, 0.05, 0.001, -0.001, 0});
  const MaskTemplate source = make(ragged, [](int u, int) { return 0.1 + 1e-4 * u; });
  expect_same(warp_through(camera, source, SE3d()), source.mask, 0, 0);
}

TEST(Warp, ShiftsAPlaneByWholePixels) {
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  expect_same(warp(source, motion(7 / 40.0, -12 / 40.0, 0)), source.mask, 7, -12);  // f q = 40 px per metre
}

TEST(Warp, MovesPlanes) {
  const Ellipse outline{300, 220, 80, 60};
  for (const auto& n : {kFacing, kSlanted}) {
    check_plane(outline, motion(0.31, 0.17, 0), n);
    check_plane(outline, motion(0.1, 0.05, 4), n);
    check_plane(outline, motion(-0.2, 0.1, -3), n);
  }
}

TEST(Warp, ApproachLeavesNoCracks) {
  const WarpedMask facing = check_plane({310, 235, 75, 55}, motion(0, 0, -6), kFacing);  // 10 m to 4 m: 2.5x
  EXPECT_NEAR(facing.mask.area, M_PI * 75 * 55 * 6.25, 0.02 * M_PI * 75 * 55 * 6.25);
  EXPECT_EQ(facing.inside_area, facing.mask.area);
  check_plane({310, 235, 60, 50}, motion(0, 0, -6.6667), kFacing);  // 3x
  check_plane({310, 235, 60, 50}, motion(0, 0, -5.5), kSlanted);
}

TEST(Warp, ApproachMagnifiesTheOutlineItself) {
  // The outline is where the interpolated mask crosses one half: neither grown nor shrunk.
  const MaskTemplate source = make(
      [](int u, int v) {
        return Ellipse{310, 235, 75, 55}.holds(u, v);
      },
      [](int, int) { return 0.1; });
  EXPECT_NEAR(warp(source, motion(0, 0, -6)).mask.area / (6.25 * source.mask.area), 1, 0.005);

  // Three times as near, a lone pixel is a cross and a line of one pixel is three pixels thick.
  const MaskTemplate thin =
      make([](int u, int v) { return (u == 300 && v == 200) || (v == 250 && u > 280 && u < 340); },
           [](int, int) { return 0.1; });
  const WarpedMask found = warp(thin, motion(0, 0, -20.0 / 3));
  for (int v = 100; v < 240; ++v)
    for (int u = 200; u < 440; ++u)
      ASSERT_EQ(found.mask.at(u, v), std::abs(u - 260) + std::abs(v - 120) < 2) << u << ' ' << v;
  for (int v = 240; v < 300; ++v)
    for (int u = 210; u < 370; ++u) ASSERT_EQ(found.mask.at(u, v), v >= 269 && v <= 271) << u << ' ' << v;
}

TEST(Warp, FollowsRotations) {
  const Ellipse outline{320, 240, 110, 60};
  for (const auto& n : {kFacing, kSlanted}) {
    check_plane(outline, motion(0, 0, 0, 0, 0, 0.5), n);              // roll
    check_plane(outline, motion(0, 0, 0, 0, 0.15, 0), n);             // yaw
    check_plane(outline, motion(0, 0, 0, -0.1, 0, 0), n);             // pitch
    check_plane(outline, motion(-1.5, 0.3, -2, 0.05, 0.1, -0.3), n);  // all at once
    check_plane(outline, motion(5.5, 0, 1.5, 0, -0.6, 0), n);         // the object turns its side
  }
}

TEST(Warp, KeepsTheHalfInsideTheImage) {
  // Centred at u = 320, moved so that the centre comes to lie on the left border.
  const WarpedMask found = check_plane({320, 240, 80, 60}, motion(-320.5 / 40, 0, 0), kFacing);
  EXPECT_EQ(found.mask.x, 0);
  EXPECT_NEAR(found.inside_area, 0.5 * M_PI * 80 * 60, 0.02 * M_PI * 80 * 60);
  for (const SE3d& T : {motion(8, 0, 0), motion(0, -6, 0), motion(0, 6, 0), motion(6, 6, -2)})
    check_plane({320, 240, 80, 60}, T, kFacing);
  const WarpedMask near = check_plane({320, 240, 80, 60}, motion(4, 0, -5), kFacing);
  EXPECT_NEAR(near.inside_area, 0.5 * 4 * M_PI * 80 * 60, 0.02 * 4 * M_PI * 80 * 60);
}

TEST(Warp, IsEmptyOutsideTheImage) {
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  for (const SE3d& T : {motion(30, 0, 0), motion(-30, 0, 0), motion(0, 30, 0), motion(0, -30, 0), motion(1e6, 0, 0)}) {
    const WarpedMask found = warp(source, T);
    EXPECT_TRUE(found.mask.empty());
    EXPECT_TRUE(found.mask.pixels.empty());
    EXPECT_TRUE(found.inverse_depth.empty());
    EXPECT_EQ(found.inside_area, 0);
  }
}

TEST(Warp, IsEmptyBehindTheCamera) {
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  for (const SE3d& T : {motion(0, 0, -10), motion(0, 0, -12), motion(0, 0, 0, 0, 3, 0)}) {
    const WarpedMask found = warp(source, T);
    EXPECT_TRUE(found.mask.empty());
    EXPECT_EQ(found.inside_area, 0);
  }
  EXPECT_TRUE(warp(MaskTemplate{}, SE3d()).mask.empty());
  EXPECT_TRUE(warp(source, motion(std::numeric_limits<double>::quiet_NaN(), 0, 0)).mask.empty());
}

TEST(Warp, KeepsThePartBeforeTheCamera) {
  // A wall along the right side, from 4 m to 20 m; the camera drives 6 m on.
  const dot::Pinhole camera(kIntrinsics);
  const dot::Vector3<double> n(0.5, 0, 0.0);  // x = 2 m
  const MaskTemplate source = make([](int u, int v) { return u >= 360 && u < 520 && v > 200 && v < 280; },
                                   [&](int u, int v) { return n.dot(camera.unproject(dot::Vector2<double>(u, v))); });
  const SE3d T = motion(0, 0, -6);
  const WarpedMask found = warp(source, T);
  ASSERT_GT(found.mask.area, 1000);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 330; u < kWidth; ++u) {
      const dot::Vector2<double> p = source_of(u, v, T, n);
      if (p.x() > 361 && p.x() < 518 && p.y() > 202 && p.y() < 278) {
        ASSERT_TRUE(found.mask.at(u, v)) << u << ' ' << v;
      }
      if (!(p.x() > 358 && p.x() < 521 && p.y() > 199 && p.y() < 281)) {
        ASSERT_FALSE(found.mask.at(u, v)) << u << ' ' << v;
      }
    }
  }
  EXPECT_EQ(found.mask.x + found.mask.width(), kWidth) << "a part has left the image";
}

TEST(Warp, NearerPartHidesTheFartherOne) {
  // Left half at 5 m, right half at 10 m; moving right by 20 and 10 pixels, the left half covers part of the right.
  const MaskTemplate source = make([](int u, int v) { return u >= 200 && u < 300 && v >= 200 && v < 250; },
                                   [](int u, int) { return u < 250 ? 0.2 : 0.1; });
  const WarpedMask found = warp(source, motion(0.25, 0, 0));
  EXPECT_EQ(found.mask.box(), (std::array<int, 4>{220, 200, 90, 50}));
  EXPECT_EQ(found.mask.area, 90 * 50);
  for (int u = 222; u < 268; ++u) ASSERT_NEAR(found.inverse_depth(u - found.mask.x, 25), 0.2f, 1e-4f) << u;
  for (int u = 274; u < 308; ++u) ASSERT_NEAR(found.inverse_depth(u - found.mask.x, 25), 0.1f, 1e-4f) << u;
}

/// Measured inverse depth: 0.1 everywhere.
Image<float> plane_depth() {
  Image<float> q(kWidth, kHeight);
  q.fill(0.1f);
  return q;
}

TEST(Warp, TrimsOccluderAndBackground) {
  const MaskTemplate source = make(
      [](int u, int v) {
        return Ellipse{300, 220, 80, 60}.holds(u, v);
      },
      [](int, int) { return 0.1; });
  Image<float> measured = plane_depth();
  const auto occluder = [](int u, int) { return u >= 280 && u < 300; };
  const auto background = [](int u, int v) { return v >= 250 && !(u >= 280 && u < 300); };
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      if (occluder(u, v)) measured(u, v) = 0.1f * 1.4f;
      if (background(u, v)) measured(u, v) = 0.1f * 0.6f;
    }
  }
  const WarpedMask found = warp(source, SE3d(), measured.view());
  EXPECT_EQ(found.inside_area, source.mask.area);
  EXPECT_LT(found.mask.area, source.mask.area);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      ASSERT_EQ(found.mask.at(u, v), source.mask.at(u, v) && !occluder(u, v) && !background(u, v)) << u << ' ' << v;
  EXPECT_EQ(found.mask.y + found.mask.height(), 250) << "the crop is tight after trimming";
  EXPECT_EQ(found.confirmed_area, found.mask.area);
  int hidden = 0;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 280; u < 300; ++u) hidden += source.mask.at(u, v);
  EXPECT_EQ(found.occluded_area, hidden);
}

// Two thirds of it are behind a wall that was not measured everywhere.
TEST(Warp, CountsWhatSomethingNearerHides) {
  const MaskTemplate source =
      make([](int u, int v) { return u >= 200 && u < 300 && v >= 200 && v < 240; }, [](int, int) { return 0.1; });
  for (const int edge : {260, 270}) {
    Image<float> measured = plane_depth();
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        if (u < edge) measured(u, v) = 0.2f;
        if (u % 10 == 0) measured(u, v) = 0;
      }
    WarpedMask found = warp(source, SE3d(), measured.view());
    EXPECT_EQ(found.occluded_area, (edge - 200) * 36);
    EXPECT_EQ(found.confirmed_area, (300 - edge) * 36);
    EXPECT_EQ(found.is_mostly_occluded(), edge == 270);
    EXPECT_EQ(found.mask.area, (300 - edge) * 40 + (edge - 200) * 4);
    dot::drop_unmeasured(measured.view(), found.mask);
    EXPECT_EQ(found.mask.area, found.confirmed_area);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u)
        ASSERT_EQ(found.mask.at(u, v), u >= edge && source.mask.at(u, v) && u % 10 != 0) << u << ' ' << v;
  }
}

TEST(Warp, KeepsWhatIsWithinTheTolerance) {
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  for (const float factor : {0.72f, 1.28f}) {
    Image<float> measured(kWidth, kHeight);
    measured.fill(0.1f * factor);
    EXPECT_EQ(warp(source, SE3d(), measured.view()).mask.area, source.mask.area) << factor;
  }
  for (const float factor : {0.68f, 1.32f}) {
    Image<float> measured(kWidth, kHeight);
    measured.fill(0.1f * factor);
    const WarpedMask found = warp(source, SE3d(), measured.view());
    EXPECT_TRUE(found.mask.empty()) << factor;
    EXPECT_EQ(found.inside_area, source.mask.area) << factor;
  }
}

TEST(Warp, MissingDepthTrimsNothing) {
  std::mt19937 random(7);
  const float invalid[] = {0, -1, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  Image<float> measured = plane_depth();
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      if (random() % 10 < 3) measured(u, v) = invalid[random() % 4];
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  expect_same(warp(source, motion(0.25, 0, 0), measured.view()), source.mask, 10, 0);
}

TEST(Warp, LeakingMaskIsCutBackToTheObject) {
  // The mask shows a strip of wall beside the object; 30 % of the depth is missing in both frames.
  const Ellipse outline{300, 220, 60, 45};
  std::mt19937 random(8);
  const auto render = [&](double shift) {
    Image<float> q(kWidth, kHeight);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) q(u, v) = random() % 10 < 3 ? 0.0f : outline.holds(u - shift, v) ? 0.1f : 0.02f;
    return q;
  };
  const Image<float> reference = render(0), current = render(24);
  Mask mask;
  dot::fill_mask(
      {0, 0, kWidth, kHeight},
      [&](int u, int v) { return outline.holds(u, v) || (u > 340 && u < 375 && v > 190 && v < 250); }, mask);
  MaskTemplate source;
  ASSERT_TRUE(dot::make_template(mask, reference.view(), kTolerance, source));
  for (int v = 0; v < mask.height(); ++v)
    for (int u = 0; u < mask.width(); ++u)
      ASSERT_NEAR(source.inverse_depth(u, v), mask.pixels(u, v) != 0 ? 0.1f : 0.0f, 1e-5f) << u << ' ' << v;

  const WarpedMask found = warp(source, motion(24 / 40.0, 0, 0), current.view());
  int wrong = 0, leaked = 0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool expected = outline.holds(u - 24, v);
      wrong += expected && !found.mask.at(u, v);
      leaked += !expected && found.mask.at(u, v);
      if (!expected && found.mask.at(u, v)) {
        ASSERT_EQ(current(u, v), 0) << "only where nothing was measured";
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(leaked, 0);
  EXPECT_LT(leaked, (mask.area - M_PI * 60 * 45) * 0.35);
}

TEST(Warp, LensWithoutDistortionIsAPinhole) {
  const MaskTemplate source = make(ragged, [](int u, int) { return 0.1 + 1e-4 * u; });
  const SE3d T = motion(0.2, -0.1, -2, 0.02, 0.03, 0.1);
  const WarpedMask pinhole = warp(source, T);
  const WarpedMask lens = warp_through(dot::RadTan(kIntrinsics, {0, 0, 0, 0, 0}), source, T);
  EXPECT_GE(iou(pinhole.mask, lens.mask), 0.999);
}

TEST(Warp, UsedBuffersLeaveNoTrace) {
  const MaskTemplate large = make(
      [](int u, int v) {
        return Ellipse{320, 240, 150, 120}.holds(u, v);
      },
      [](int, int) { return 0.2; });
  const MaskTemplate small = make(ragged, [](int, int) { return 0.1; });
  const SE3d T = motion(0.13, 0.07, -2, 0, 0, 0.1);
  const dot::Pinhole camera(kIntrinsics);
  dot::WarpWorkspace workspace;
  WarpedMask found;
  dot::warp(large, T, camera, {}, kTolerance, workspace, found);
  dot::warp(small, T, camera, {}, kTolerance, workspace, found);
  const WarpedMask expected = warp(small, T);
  expect_same(found, expected.mask, 0, 0);
  EXPECT_EQ(found.inside_area, expected.inside_area);
}

TEST(Warp, RefusesDepthOfAnotherSize) {
  const MaskTemplate source = make(ragged, [](int, int) { return 0.1; });
  const Image<float> measured(kWidth, kHeight - 1);
  EXPECT_THROW(warp(source, SE3d(), measured.view()), std::invalid_argument);
}

}  // namespace
