// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/select.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "dot/camera/depth_noise.hpp"
#include "support/depth_cameras.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::Box;
using dot::Image;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Selector;
using namespace dot::test;

constexpr Box whole{0, 0, 320, 240};

dot::DepthNoise stereo_noise() {
  dot::DepthNoiseSettings s;
  s.source = dot::DepthSource::Stereo;
  return {s, small_camera()};
}

/// A view of the hopper and a selector over it.
struct Fixture {
  Pinhole camera{small_camera()};
  dot::DepthNoise noise = stereo_noise();
  dot::SelectionSettings settings;
  Rendering view;
  Pyramid pyramid;
  Image<float> q;

  explicit Fixture(const Degradation& degradation = {}) {
    static const Rendering exact = Scene{{hopper(21)}}.render(Pinhole(small_camera()), SE3d{});
    view = degraded(exact, degradation);
    use_view();
  }
  void use_view() {
    pyramid.build(view.grey.view(), 3);
    q = view.inverse_depth();
  }
  mutable dot::SelectionWorkspace workspace;
  Selector<Pinhole, dot::DepthNoise> selector() const {
    return {camera, noise, pyramid, q.view(), settings, workspace};
  }
  dot::SelectionRegion region(const Box& box, int budget) const {
    dot::SelectionRegion r;
    r.box = box;
    r.surface = {q.row(box.y) + box.x, box.width, box.height, q.view().stride};
    r.budget = budget, r.radius = settings.window_radius, r.min_gradient = settings.min_gradient;
    return r;
  }
  PointSet select(const Box& box, int budget) const {
    PointSet points;
    selector()(region(box, budget), points);
    return points;
  }
  /// @param accept (x, y) -> bool, pixels of the image.
  template <typename Accept>
  PointSet select(const Box& box, int budget, Accept&& accept) const {
    Image<std::uint8_t> mask(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
      for (int x = 0; x < box.width; ++x) mask(x, y) = accept(box.x + x, box.y + y) ? 255 : 0;
    dot::SelectionRegion r = region(box, budget);
    r.mask = mask.view();
    PointSet points;
    selector()(r, points);
    return points;
  }
};

int column(const PointSet& p, std::size_t i) { return static_cast<int>(p.u[i]); }
int row(const PointSet& p, std::size_t i) { return static_cast<int>(p.v[i]); }

TEST(Selector, SpendsAboutItsBudget) {
  const Fixture f;
  for (const int budget : {100, 500, 3000}) {
    const int found = f.select(whole, budget).size();
    EXPECT_GT(found, budget / 2) << budget;    // nearly every cell of this scene has gradient and depth
    EXPECT_LT(found, 1.4 * budget) << budget;  // cells of whole pixels
  }
}

TEST(Selector, TakesAPixelOnce) {
  const Fixture f;
  const PointSet points = f.select(whole, 3000);
  std::set<std::pair<int, int>> pixels;
  for (std::size_t i = 0; i < points.u.size(); ++i) pixels.insert({column(points, i), row(points, i)});
  EXPECT_EQ(pixels.size(), points.u.size());
}

TEST(Selector, StaysInTheBoxAndWhereItMay) {
  const Fixture f;
  const Box box{50, 60, 120, 90};
  const auto accept = [](int x, int y) { return (x / 10 + y / 10) % 2 == 0; };
  const PointSet points = f.select(box, 400, accept);
  EXPECT_GT(points.size(), 100);
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    const int x = column(points, i), y = row(points, i);
    EXPECT_TRUE(accept(x, y)) << x << ", " << y;
    EXPECT_TRUE(x >= 50 && y >= 60 && x < 170 && y < 150) << x << ", " << y;
  }
  EXPECT_EQ(f.select(whole, 400, [](int, int) { return false; }).size(), 0);
  EXPECT_EQ(f.select({318, 10, 2, 30}, 400).size(), 0);  // at the border alone
}

// Of what has no mask the edges are not known beforehand.
TEST(Selector, TakesNoDepthBetweenTwoSurfaces) {
  Fixture f;
  Body post = box(0, {0.1, 2, 0.1}, 80, 0.1, 0.6);
  post.T_world_body.t = {0.25, 0, 1.8};
  f.view = Scene{{hopper(21), post}}.render(f.camera, SE3d{});
  const Image<float> exact = f.view.inverse_depth();
  Random random(3);
  see_by_time_of_flight(f.view, random);
  f.use_view();
  const PointSet points = f.select(whole, 2000);
  EXPECT_GT(points.size(), 1000);
  int wrong = 0;
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    float error = 1;  // at the edge a point may have the depth of either surface
    for (int y = row(points, i) - 3; y <= row(points, i) + 3; ++y)
      for (int x = column(points, i) - 3; x <= column(points, i) + 3; ++x)
        if (exact.contains(x, y)) error = std::min(error, std::abs(points.q[i] - exact(x, y)));
    wrong += error > 0.02f && error > 3 * points.sigma_q[i];  // 1/m: the post is at 0.59, the walls are at 0.17 to 0.33
  }
  EXPECT_LT(wrong, 4);
}

TEST(Selector, TakesNothingWithoutGradient) {
  Fixture f;
  for (int y = 0; y < 240; ++y)
    for (int x = 100; x < 220; ++x) f.view.intensity(x, y) = static_cast<float>(90 + 0.5 * x);  // too gentle a ramp
  f.view.round();
  f.use_view();
  f.settings.min_gradient = 3;
  const PointSet points = f.select(whole, 1500);
  EXPECT_GT(points.size(), 400);
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    const int x = column(points, i), y = row(points, i);
    const dot::Sample s = sample(f.pyramid.levels[0], points.u[i], points.v[i]);
    EXPECT_GE(std::hypot(s.gx, s.gy), 3) << x << ", " << y;
    EXPECT_FALSE(x > 102 && x < 217) << x << ", " << y;  // beyond the blur's reach
  }
}

TEST(Selector, TakesNothingWithoutDepth) {
  Degradation degradation;
  degradation.missing_depth = 0.4;
  Fixture f(degradation);
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 160; ++x) f.q(x, y) = 0;
  const PointSet points = f.select(whole, 1500);
  EXPECT_GT(points.size(), 400);
  for (std::size_t i = 0; i < points.u.size(); ++i) EXPECT_GT(f.q(column(points, i), row(points, i)), 0);
}

TEST(Selector, PointsLieOnTheirRaysAtTheTrueDepth) {
  const Fixture f;
  const PointSet points = f.select(whole, 1000);
  int exact = 0;
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    const auto ray = f.camera.unproject(dot::Vector2<float>(points.u[i], points.v[i]));
    EXPECT_FLOAT_EQ(points.x[i], ray.x());
    EXPECT_FLOAT_EQ(points.y[i], ray.y());
    EXPECT_GT(points.sigma_q[i], 0);
    exact += std::abs(points.q[i] - f.q(column(points, i), row(points, i))) < 1e-4f;
  }
  EXPECT_GT(exact, 0.8 * points.size());  // the others are at the edges between the walls
}

TEST(Selector, DepthIsBetterThanThePixels) {
  Degradation degradation;
  const dot::DepthNoise noise = stereo_noise();
  degradation.depth_noise = noise.pixel_sigma(0.2);
  degradation.seed = 5;
  const Fixture clean, noisy(degradation);
  const PointSet points = noisy.select(whole, 1500);
  EXPECT_GT(points.size(), 700);
  double squared = 0, normalised = 0;
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    const double error = points.q[i] - clean.q(column(points, i), row(points, i));
    squared += error * error;
    normalised += error * error / (points.sigma_q[i] * points.sigma_q[i]);
  }
  EXPECT_LT(std::sqrt(squared / points.size()), 0.5 * degradation.depth_noise);
  // Here the pixels' errors are independent, for which the claimed sigma is careful; it must never be too small.
  EXPECT_LT(normalised / points.size(), 1.5);
}

TEST(Selector, LeavesOutPixelsWhoseSurroundingsContradictThem) {
  Fixture f;
  for (int y = 80; y < 160; y += 7)
    for (int x = 100; x < 220; x += 7) f.q(x, y) = 0.9f;  // single wrong matches
  const PointSet points = f.select({100, 80, 120, 80}, 3000);
  EXPECT_GT(points.size(), 500);
  for (const float q : points.q) EXPECT_LT(q, 0.4f);
}

TEST(Selector, GivesAllASharedPlane) {
  Fixture f;
  f.q.fill(0.02f);
  f.q(160, 120) = 0.5f;  // not of that plane
  dot::PlaneFit plane;
  plane.q = 0.021f, plane.du = 1e-6f, plane.dv = 2e-6f, plane.inliers = 300, plane.variance = 1e-8f;
  PointSet points;
  dot::SelectionRegion region = f.region({120, 90, 80, 60}, 5000);
  region.min_gradient = 3;
  region.shared = &plane;
  f.selector()(region, points);
  EXPECT_GT(points.size(), 500);
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    EXPECT_FLOAT_EQ(points.q[i], 0.021f + 1e-6f * (points.u[i] - 160) + 2e-6f * (points.v[i] - 120));
    EXPECT_FALSE(column(points, i) == 160 && row(points, i) == 120);
  }
}

// In the order of the cells; of equal gradients the first in the order of rows.
TEST(Selector, TakesTheStrongestOfEachCell) {
  Fixture f;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; x += 2) f.pyramid.levels[0](x, y) = f.pyramid.levels[0](x + 1, y);  // many are equal
  const auto accept = [](int x, int y) { return (x + y) % 7 != 0; };
  const auto& grey = f.pyramid.levels[0];
  const auto strength = [&](int x, int y) {
    const int gx = grey(x + 1, y) - grey(x - 1, y), gy = grey(x, y + 1) - grey(x, y - 1);
    return gx * gx + gy * gy;
  };
  f.settings.window_radius = 6;  // where every pixel of the scene has a plane, but at its edges
  const PointSet points = f.select(whole, 1200, accept);
  const int cell = 7;  // sqrt(320 * 240 * 6 / 7 / 1200), of the area without its border
  std::size_t i = 0;
  int found = 0, cells = 0;
  for (int cy = 4; cy < 236; cy += cell)
    for (int cx = 4; cx < 316; cx += cell) {
      int best = static_cast<int>(4 * f.settings.min_gradient * f.settings.min_gradient), bx = -1, by = -1;
      for (int y = cy; y < std::min(cy + cell, 236); ++y)
        for (int x = cx; x < std::min(cx + cell, 316); ++x)
          if (accept(x, y) && f.q(x, y) > 0 && strength(x, y) > best) best = strength(x, y), bx = x, by = y;
      if (bx < 0) continue;
      ++cells;
      if (i < points.u.size() && column(points, i) == bx && row(points, i) == by) ++i, ++found;
    }
  EXPECT_EQ(found, points.size());  // no point is anything else
  EXPECT_GT(found, 0.8 * cells);    // the others have no plane
}

// A few points for a large region: each is the best of some rows of a large cell.
TEST(Selector, SearchesSomeRowsOfALargeCell) {
  const Fixture f;
  const PointSet points = f.select(whole, 30);
  const int cell = 49, step = 4;  // sqrt(312 * 232 / 30); so many rows that at most 16 are searched
  EXPECT_GT(points.size(), 15);
  std::set<std::pair<int, int>> cells;
  for (std::size_t i = 0; i < points.u.size(); ++i) {
    EXPECT_EQ((row(points, i) - 4) % cell % step, 0);
    cells.insert({(column(points, i) - 4) / cell, (row(points, i) - 4) / cell});
  }
  EXPECT_EQ(cells.size(), points.u.size());
}

TEST(Selector, SamplesTheIntensitiesOfEachLevel) {
  const Fixture f;
  PointSet points = f.select(whole, 800);
  f.selector().sample_intensities(points);
  ASSERT_EQ(points.levels, 3);
  for (std::size_t l = 0; l < 3; ++l) {
    ASSERT_EQ(points.intensity[l].size(), points.u.size());
    const Image<std::uint8_t>& level = f.pyramid.levels[l];
    const float scale = 1.f / static_cast<float>(1 << l);
    for (std::size_t i = 0; i < points.u.size(); ++i) {
      const float u = (points.u[i] + 0.5f) * scale - 0.5f, v = (points.v[i] + 0.5f) * scale - 0.5f;
      if (u < 1 || v < 1 || u > static_cast<float>(level.width() - 3) || v > static_cast<float>(level.height() - 3))
        continue;
      const dot::Sample s = sample(level, u, v);
      EXPECT_NEAR(points.intensity[l][i], s.value, 1e-3);  // float rounding
      EXPECT_NEAR(points.gu[l][i], s.gx, 1e-3);
      EXPECT_NEAR(points.gv[l][i], s.gy, 1e-3);
    }
  }
}

TEST(Selector, AppendsToWhatThereIs) {
  const Fixture f;
  PointSet points;
  points.push(1, 2, 3, 4, 5, 6);
  f.selector()(f.region(whole, 200), points);
  EXPECT_GT(points.size(), 100);
  EXPECT_EQ(points.u[0], 1);
  EXPECT_EQ(points.sigma_q[0], 6);
  points.clear();
  EXPECT_EQ(points.size(), 0);
  EXPECT_TRUE(points.sigma_q.empty());
}

}  // namespace
