// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/guarded.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

/// @file
/// Every kernel of this machine against the same fit in double, pixel by pixel. Tolerances: 1e-5 of the gate, at the
/// pixel and over the window. Where a residual lies within rounding of the gate the two may differ by that pixel: the
/// random depths leave no such case.

namespace {

namespace kernel = dot::kernel;
using dot::test::Guarded;
using dot::test::kernel_variants;
using dot::test::Random;

struct Depths {
  int width, height;
  std::vector<float> q;

  Depths(int w, int h) : width(w), height(h), q(static_cast<std::size_t>(w * h)) {}
  float& at(int x, int y) { return q[static_cast<std::size_t>(y * width + x)]; }
  kernel::InverseDepth view() const { return {q.data(), width, height, width * static_cast<std::ptrdiff_t>(4)}; }
};

kernel::Plane reference(const kernel::InverseDepth& image, const kernel::PlaneWindow& window,
                        const kernel::PlaneSeed& seed) {
  const int x0 = std::max(seed.u - window.radius, 0), x1 = std::min(seed.u + window.radius + 1, image.width);
  const int y0 = std::max(seed.v - window.radius, 0), y1 = std::min(seed.v + window.radius + 1, image.height);
  if (x1 <= x0 || y1 <= y0) return {};
  const int read = (y1 - y0 + window.row_step - 1) / window.row_step;
  double q0 = seed.q, du = 0, dv = 0, variance = 0, pixels = 0;
  for (int pass = 0; pass < 3; ++pass) {
    const double gate = (pass == 0 ? 3 : 1) * static_cast<double>(seed.gate);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, r = 0, xr = 0, yr = 0, rr = 0;
    for (int v = y0; v < y1; v += window.row_step)
      for (int u = x0; u < x1; ++u) {
        const float q = image.data[v * image.width + u];
        const double dx = u - seed.u, dy = v - seed.v, e = static_cast<double>(q) - q0 - du * dx - dv * dy;
        if (!(q > 0) || std::abs(e) > gate) continue;
        n += 1, x += dx, y += dy, xx += dx * dx, xy += dx * dy, yy += dy * dy;
        r += e, xr += dx * e, yr += dy * e, rr += e * e;
      }
    pixels = n * (y1 - y0) / read;
    if (n < 1 || pixels < window.min_inliers) return {};
    const double cxx = xx - x * x / n, cxy = xy - x * y / n, cyy = yy - y * y / n;
    const double cxr = xr - x * r / n, cyr = yr - y * r / n, det = cxx * cyy - cxy * cxy;
    if (det < 1e-6 * n * n) return {};
    const double a = (cyy * cxr - cxy * cyr) / det, b = (cxx * cyr - cxy * cxr) / det;
    q0 += (r - a * x - b * y) / n, du += a, dv += b;
    variance = (rr - r * r / n - a * cxr - b * cyr) / n;
  }
  if (!(q0 > 0)) return {};
  return {static_cast<float>(q0), static_cast<float>(du), static_cast<float>(dv), static_cast<float>(variance),
          static_cast<int>(std::lround(pixels))};
}

void expect_same(const Depths& depths, const kernel::PlaneWindow& window, const std::vector<kernel::PlaneSeed>& seeds,
                 int min_fits) {
  for (const kernel::Kernels* k : kernel_variants()) {
    std::vector<kernel::Plane> planes(seeds.size());
    k->fit_planes(depths.view(), window, seeds.data(), static_cast<int>(seeds.size()), planes.data());
    int fits = 0;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const kernel::Plane expected = reference(depths.view(), window, seeds[i]), &found = planes[i];
      ASSERT_EQ(found.inliers, expected.inliers) << k->name << ", seed " << i;
      if (!found.inliers) continue;
      ++fits;
      const float tolerance = 1e-5f * seeds[i].gate;
      EXPECT_NEAR(found.q, expected.q, tolerance) << k->name;
      EXPECT_NEAR(found.du * static_cast<float>(window.radius), expected.du * static_cast<float>(window.radius),
                  tolerance);
      EXPECT_NEAR(found.dv * static_cast<float>(window.radius), expected.dv * static_cast<float>(window.radius),
                  tolerance);
      EXPECT_NEAR(found.variance, expected.variance, tolerance * seeds[i].gate);
    }
    EXPECT_GE(fits, min_fits) << k->name;
  }
}

/// Two slanted surfaces with noise, an edge between them and a tenth of the pixels without depth, in every way.
Depths random_depths(int width, int height, Random& random) {
  Depths d(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double plane = x < width / 2 ? 0.2 + 0.0005 * x - 0.001 * y : 0.5 - 0.002 * x + 0.0003 * y;
      d.at(x, y) = static_cast<float>(plane + random.normal(0.002));
      const float none[] = {0.f, -1.f, std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::infinity()};
      if (random.uniform() < 0.1) d.at(x, y) = none[static_cast<int>(random.uniform(0, 5))];
    }
  return d;
}

std::vector<kernel::PlaneSeed> seeds_of(const Depths& d, int step, float gate) {
  std::vector<kernel::PlaneSeed> seeds;
  for (int v = 0; v < d.height; v += step)
    for (int u = 0; u < d.width; u += step)
      seeds.push_back({u, v, u < d.width / 2 ? 0.2f : 0.4f, gate * static_cast<float>(1 + (u + v) % 3)});
  return seeds;
}

TEST(PlaneKernel, AgreesWithTheFitInDouble) {
  Random random(5);
  for (const int radius : {0, 1, 3, 5, 6, 9, 20}) {
    const Depths d = random_depths(61, 47, random);
    const kernel::PlaneWindow window{radius, radius < 7 ? 1 : 2, radius * radius + 1};
    expect_same(d, window, seeds_of(d, 3, 0.011f), radius > 1 ? 250 : 0);
  }
}

TEST(PlaneKernel, TakesAnyNumberOfSeeds) {
  Random random(6);
  const Depths d = random_depths(40, 30, random);
  std::vector<kernel::PlaneSeed> seeds = seeds_of(d, 4, 0.011f);
  for (const std::size_t n : {1u, 3u, 4u, 7u, 8u, 15u, 16u, 17u, 33u}) {
    std::vector<kernel::PlaneSeed> some(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(n));
    expect_same(d, {5, 1, 30}, some, static_cast<int>(n) / 2);
  }
}

// No fit of one seed may depend on which others share its vector.
TEST(PlaneKernel, SeedsDoNotDisturbEachOther) {
  Random random(7);
  const Depths d = random_depths(60, 40, random);
  std::vector<kernel::PlaneSeed> seeds = seeds_of(d, 5, 0.011f);
  for (std::size_t i = 0; i < seeds.size(); i += 3) seeds[i].q = 7;  // nothing there
  seeds[4] = {-100, 3, 0.2f, 0.01f}, seeds[5] = {5, 700, 0.2f, 0.01f};
  for (const kernel::Kernels* k : kernel_variants()) {
    std::vector<kernel::Plane> together(seeds.size());
    k->fit_planes(d.view(), {5, 1, 30}, seeds.data(), static_cast<int>(seeds.size()), together.data());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      kernel::Plane alone;
      k->fit_planes(d.view(), {5, 1, 30}, &seeds[i], 1, &alone);
      ASSERT_EQ(together[i].inliers, alone.inliers) << k->name << ", seed " << i;
      EXPECT_EQ(together[i].q, alone.q);
      EXPECT_EQ(together[i].variance, alone.variance);
      const bool nothing_there = i % 3 == 0 || i == 4 || i == 5;
      EXPECT_TRUE(!nothing_there || alone.inliers == 0);
    }
  }
}

TEST(PlaneKernel, FindsNothingInAnEmptyImage) {
  const kernel::PlaneSeed seed{0, 0, 1, 1};
  for (const kernel::Kernels* k : kernel_variants()) {
    kernel::Plane plane;
    plane.inliers = 3;
    k->fit_planes({}, {5, 1, 1}, &seed, 1, &plane);
    EXPECT_EQ(plane.inliers, 0) << k->name;
  }
}

TEST(PlaneKernel, ReadsWithinTheImage) {
  constexpr int kWidth = 23, kHeight = 19, kStride = 26;
  const std::size_t bytes = 4 * (kStride * (kHeight - 1) + kWidth);
  for (const bool at_the_end : {true, false}) {
    const Guarded image(bytes, at_the_end);
    for (std::size_t i = 0; i < bytes / 4; ++i) image.floats()[i] = 0.5f;
    for (const int radius : {0, 1, 5, 30})
      for (const int u : {0, 1, 11, kWidth - 1})
        for (const int v : {0, 1, 9, kHeight - 1}) {
          const kernel::PlaneSeed seeds[3] = {{u, v, 0.5f, 0.1f}, {kWidth - 1 - u, v, 0.5f, 0.1f}, {-99, 999, 1, 1}};
          for (const kernel::Kernels* k : kernel_variants()) {
            kernel::Plane planes[3];
            k->fit_planes({image.floats(), kWidth, kHeight, 4 * kStride}, {radius, 1, 1}, seeds, 3, planes);
            EXPECT_EQ(planes[0].inliers > 0, radius > 0) << k->name;  // one pixel is no plane
            EXPECT_EQ(planes[2].inliers, 0);
          }
        }
  }
}

}  // namespace
