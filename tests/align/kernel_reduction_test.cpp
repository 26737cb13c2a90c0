// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/align/kernel_reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "dot/camera/radtan.hpp"
#include "dot/kernel/dispatch.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

/// @file
/// Every kernel of this machine against SerialReduction. Tolerances: 1e-5 of the natural size of each sum; residuals to
/// .05 grey values (a coordinate of a float pixel is good to 1e-4); the same points seen, except those that lie within
/// 1e-3 of a bound.

namespace {

using dot::AlignState;
using dot::DepthTerm;
using dot::Image;
using dot::KernelReduction;
using dot::KernelVariant;
using dot::NormalEquations;
using dot::PointResiduals;
using dot::PointSet;
using dot::ResidualNoise;
using dot::SE3d;
using dot::SerialReduction;
using dot::Vector3;
using dot::test::kernel_variants;
using dot::test::Random;
namespace kernel = dot::kernel;

const dot::Pinhole camera({140, 135, 79.2, 58.7, 160, 120, 0});
const SE3d motion = SE3d::exp((dot::Vector6<double>() << 0.1, -0.05, 0.2, 0.02, -0.05, 0.03).finished());
const ResidualNoise noise{4, 0.06f, 1.345f, 4.685f};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image<std::uint8_t> texture(int width, int height) {
  Image<std::uint8_t> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image(x, y) = static_cast<std::uint8_t>(128 + 60 * std::sin(0.31 * x + 0.07 * y) + 50 * std::cos(0.23 * y));
  return image;
}

/// Points over the image and somewhat beyond, near and far, with the intensities of a slightly different image.
PointSet random_points(int n, unsigned seed) {
  Random random(seed);
  PointSet points;
  points.levels = 1;
  for (int i = 0; i < n; ++i) {
    const auto u = static_cast<float>(random.uniform(-4, 164)), v = static_cast<float>(random.uniform(-4, 124));
    const auto ray = camera.unproject(dot::Vector2<float>(u, v));
    const auto q = static_cast<float>(random.uniform(0, 1.5));
    points.push(u, v, ray.x(), ray.y(), q, 0.02f * q);
    const double grey = 128 + 60 * std::sin(0.31 * u + 0.07 * v) + 50 * std::cos(0.23 * v) + random.normal(8);
    points.intensity[0].push_back(static_cast<float>(grey));
    points.gu[0].push_back(static_cast<float>(18.6 * std::cos(0.31 * u + 0.07 * v)));
    points.gv[0].push_back(static_cast<float>(4.2 * std::cos(0.31 * u + 0.07 * v) - 11.5 * std::sin(0.23 * v)));
  }
  return points;
}

/// A depth term whose measurements agree, disagree, hide, or are missing.
struct Measured {
  Image<float> q{160, 120};
  Image<std::uint8_t> occluders{160, 120};
  DepthTerm term;

  explicit Measured(unsigned seed) {
    Random random(seed);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        q(x, y) = random.uniform() < 0.2 ? 0.f : static_cast<float>(random.uniform(0, 1.2));
        occluders(x, y) = random.uniform() < 0.1;
      }
    term.inverse_depth = q.view();
    term.occluders = occluders.view();
    term.sigma = 0.03f;
    term.weight = 0.4f;
  }
};

/// Whether float rounding may decide what happens to a point.
bool doubtful(const PointSet& points, std::size_t i, const AlignState& state, const DepthTerm& depth) {
  const double q = static_cast<double>(points.q[i]);
  const Vector3<double> X =
      state.T.R * Vector3<double>(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]), 1) +
      q * state.T.t;
  if (std::abs(X.z() - 1e-3) < 1e-5) return true;
  const auto pixel = camera.project<double>(X);
  const double margin = 1e-3;
  for (const double bound : {1.0, camera.width() - 3.0})
    if (std::abs(pixel.x() - bound) < margin) return true;
  for (const double bound : {1.0, camera.height() - 3.0})
    if (std::abs(pixel.y() - bound) < margin) return true;
  if (!depth.inverse_depth.data) return false;
  const double u = pixel.x() + 0.5, v = pixel.y() + 0.5;
  if (std::abs(u - std::round(u)) < margin || std::abs(v - std::round(v)) < margin) return true;
  if (!depth.inverse_depth.contains(static_cast<int>(u), static_cast<int>(v))) return false;
  const double qi = q / X.z(),
               measured = static_cast<double>(depth.inverse_depth(static_cast<int>(u), static_cast<int>(v)));
  const double limit = std::max(0.15 * qi, static_cast<double>(depth.occlusion_sigmas * depth.sigma));
  return std::abs(measured - qi - limit) < 1e-4;
}

void expect_same(const NormalEquations& got, const NormalEquations& want, const char* name) {
  EXPECT_EQ(got.seen, want.seen) << name;
  EXPECT_EQ(got.occluded, want.occluded) << name;
  EXPECT_EQ(got.inside, want.inside) << name;
  EXPECT_NEAR(got.cost, want.cost, 1e-5 * want.cost) << name;
  const double cost = std::sqrt(1 + 2 * want.cost * want.seen);
  for (int r = 0; r < 8; ++r) {
    const double size = std::sqrt(want.H(r, r));
    for (int c = 0; c < 8; ++c)
      EXPECT_NEAR(got.H(r, c), want.H(r, c), 1e-5 * size * std::sqrt(want.H(c, c))) << name << r << c;
    EXPECT_NEAR(got.g[r], want.g[r], 1e-5 * size * cost) << name << r;
    for (std::size_t m = 0; m < 4; ++m) {
      // |dr/dq| of single points is up to hundreds of times their mean.
      EXPECT_NEAR(got.modes[m][r], want.modes[m][r], 1e-5 * size * (1 + std::sqrt(want.H(2, 2)))) << name << m << r;
    }
  }
}

const Vector3<double> centre(0.3, -0.2, 2.5);

/// Residuals and sums of all variants over points of which none is doubtful.
void compare(const PointSet& points, const AlignState& state, const DepthTerm& depth, std::size_t* seen = nullptr,
             const ResidualNoise& model = noise) {
  const Image<std::uint8_t> image = texture(160, 120);
  const std::size_t n = points.u.size();
  std::vector<std::uint8_t> excluded(n);
  for (std::size_t i = 0; i < n; ++i) excluded[i] = i % 11 == 3 || doubtful(points, i, state, depth);
  PointResiduals want;
  SerialReduction::residuals(points, 0, camera, image, state, model, depth, want);
  const NormalEquations sums =
      SerialReduction::linearize(points, 0, camera, image, state, model, depth, excluded.data(), centre);
  if (seen) *seen = static_cast<std::size_t>(sums.seen);
  for (const kernel::Kernels* k : kernel_variants()) {
    const KernelReduction reduction{k};
    PointResiduals got;
    reduction.residuals(points, 0, camera, image, state, model, depth, got);
    ASSERT_EQ(got.size(), n);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (doubtful(points, i, state, depth)) {
        ++differ;
        continue;
      }
      ASSERT_EQ(got.visibility[i], want.visibility[i]) << k->name << " " << i;
      EXPECT_NEAR(got.r[i], want.r[i], 0.05) << k->name << " " << i;
      EXPECT_NEAR(got.value[i], want.value[i], 0.05) << k->name << " " << i;
      EXPECT_NEAR(got.extra[i], want.extra[i], 0.02 + 0.01 * static_cast<double>(want.extra[i])) << k->name << " " << i;
      EXPECT_NEAR(got.r_depth[i], want.r_depth[i], 1e-5) << k->name << " " << i;
    }
    EXPECT_LE(differ, n / 50 + 1);
    expect_same(reduction.linearize(points, 0, camera, image, state, model, depth, excluded.data(), centre), sums,
                k->name);
  }
}

TEST(Kernel, AgreesWithTheSerialReduction) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::size_t seen = 0;
    compare(random_points(3000, seed), {motion, 1.08, -5}, {}, &seen);
    EXPECT_GT(seen, 1500u);
    EXPECT_LT(seen, 2800u);
  }
}

TEST(Kernel, AgreesOnTheDepthTerm) {
  for (const unsigned seed : {4u, 5u, 6u}) {
    Measured measured(seed);
    std::size_t seen = 0;
    compare(random_points(3000, seed), {motion, 0.95, 3}, measured.term, &seen);
    EXPECT_GT(seen, 800u);
    measured.term.occluders = {};
    compare(random_points(3000, seed), {motion, 0.95, 3}, measured.term, &seen);
    measured.term.weight = measured.term.sigma = 0;
    compare(random_points(3000, seed), {SE3d{}, 1, 0}, measured.term, &seen);
  }
}

TEST(Kernel, AgreesWhosesoeverGradientsAreTaken) {
  for (const dot::GradientSource gradient : {dot::GradientSource::Reference, dot::GradientSource::Mean}) {
    ResidualNoise by = noise;
    by.gradient = gradient;
    compare(random_points(1500, 16), {motion, 1.08, -5}, {}, nullptr, by);
    compare(random_points(1501, 17), {motion, 1.08, -5}, Measured(17).term, nullptr, by);
    compare(random_points(5, 18), {motion, 1.08, -5}, {}, nullptr, by);
    PointSet without = random_points(5, 18);
    without.gu[0].clear();
    EXPECT_THROW(KernelReduction{}.linearize(without, 0, camera, texture(160, 120), {}, by, {}, nullptr),
                 std::invalid_argument);
  }
}

TEST(Kernel, AgreesForAnyNumberOfPoints) {
  const Measured measured(7);
  for (int n = 0; n <= 40; ++n) {
    compare(random_points(n, 8), {motion, 1, 0}, {});
    compare(random_points(n, 9), {motion, 1, 0}, measured.term);
  }
  for (const int n : {127, 128, 129, 1023, 1024, 1025, 1040})
    compare(random_points(n, 10), {motion, 1, 0}, measured.term);
}

/// Costs and moments of all variants over the points of which none is doubtful.
void compare_places(const PointSet& points, const AlignState& state, const DepthTerm& depth,
                    const ResidualNoise& model = noise) {
  const Image<std::uint8_t> image = texture(160, 120);
  PointSet clear;
  clear.take_if(points, [&](std::size_t i) { return !doubtful(points, i, state, depth); });
  PointResiduals scratch;
  const kernel::Costs want = SerialReduction::costs(clear, 0, camera, image, nullptr, state, model, depth, scratch);
  const kernel::Moments moments = SerialReduction::moments(clear, 0, camera, image, nullptr, state, scratch);
  for (const kernel::Kernels* k : kernel_variants()) {
    const KernelReduction reduction{k};
    const kernel::Costs got = reduction.costs(clear, 0, camera, image, nullptr, state, model, depth, scratch);
    EXPECT_EQ(got.seen, want.seen) << k->name;
    EXPECT_NEAR(got.sum, want.sum, 1e-3 * (1 + want.sum)) << k->name;
    const kernel::Moments m = reduction.moments(clear, 0, camera, image, nullptr, state, scratch);
    EXPECT_EQ(m.seen, moments.seen) << k->name;
    for (const auto sum : {&kernel::Moments::x, &kernel::Moments::y})
      EXPECT_NEAR(m.*sum, moments.*sum, 1e-3f * std::sqrt(static_cast<float>(m.seen) * moments.xx) + 1e-3f) << k->name;
    for (const auto sum : {&kernel::Moments::xx, &kernel::Moments::xy, &kernel::Moments::yy})
      EXPECT_NEAR(m.*sum, moments.*sum, 1e-3f * std::sqrt(moments.xx * moments.yy) + 1e-3f) << k->name;
  }
}

TEST(Kernel, CostsAndMomentsAreThoseOfTheResiduals) {
  for (const int n : {0, 1, 5, 17, 333, 3000}) {
    Measured measured(21);
    compare_places(random_points(n, 21), {motion, 1.08, -5}, {});
    compare_places(random_points(n, 22), {motion, 0.95, 3}, measured.term);
    measured.term.weight = measured.term.sigma = 0;
    compare_places(random_points(n, 23), {SE3d{}, 1, 0}, measured.term);
  }
  for (const dot::GradientSource gradient : {dot::GradientSource::Reference, dot::GradientSource::Mean}) {
    ResidualNoise by = noise;
    by.gradient = gradient;
    compare_places(random_points(1501, 24), {motion, 1.08, -5}, {}, by);
  }
  ResidualNoise wide = noise;
  wide.tukey = 30;  // costs that are a small share of the highest one, of many points
  compare_places(random_points(50000, 26), {motion, 1.08, -5}, Measured(26).term, wide);
}

/// A pyramid of one level.
dot::Pyramid level_of(const Image<std::uint8_t>& image) {
  dot::Pyramid pyramid;
  pyramid.levels.push_back(image);
  return pyramid;
}

/// The values of quads are those of the image. So are the gradients where the image has one slope.
TEST(Kernel, QuadsShowTheSameImage) {
  Image<std::uint8_t> across(160, 120), down(160, 120);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x)
      across(x, y) = static_cast<std::uint8_t>(x), down(x, y) = static_cast<std::uint8_t>(2 * y);
  ResidualNoise without_gradient = noise, with_gradient = noise;
  without_gradient.gradient_noise = 0;
  with_gradient.gradient_noise = 2;
  PointSet points = random_points(1501, 25), exact = points;
  std::fill(exact.sigma_q.begin(), exact.sigma_q.end(), 0.f);
  const Measured measured(25);
  const AlignState state{motion, 1.08, -5};
  PointResiduals scratch;
  for (const kernel::Kernels* k : kernel_variants()) {
    const KernelReduction reduction{k};
    const auto compare = [&](const Image<std::uint8_t>& image, const PointSet& seen, const ResidualNoise& model,
                             const DepthTerm& depth) {
      dot::Quads quads;
      quads.copy_level(level_of(image), 0);
      const auto want = reduction.costs(seen, 0, camera, image, nullptr, state, model, depth, scratch);
      const auto got = reduction.costs(seen, 0, camera, image, &quads, state, model, depth, scratch);
      EXPECT_GT(got.seen, 300) << k->name;
      EXPECT_EQ(got.seen, want.seen) << k->name;
      EXPECT_NEAR(got.sum, want.sum, 1e-4 * want.sum) << k->name;
      const auto moments = reduction.moments(seen, 0, camera, image, &quads, state, scratch);
      EXPECT_NEAR(moments.xy, reduction.moments(seen, 0, camera, image, nullptr, state, scratch).xy,
                  1e-4f * std::sqrt(moments.xx * moments.yy))
          << k->name;
    };
    compare(texture(160, 120), exact, without_gradient, {});
    compare(texture(160, 120), exact, without_gradient, measured.term);
    dot::Quads smaller;  // of another level: not read
    smaller.copy_level(level_of(texture(80, 60)), 0);
    EXPECT_EQ(reduction.costs(points, 0, camera, across, &smaller, state, noise, {}, scratch).sum,
              reduction.costs(points, 0, camera, across, nullptr, state, noise, {}, scratch).sum);
    compare(across, points, with_gradient, {});
    compare(down, points, with_gradient, {});
  }
}

TEST(Kernel, WhatIsNotSeenAddsNothing) {
  const Image<std::uint8_t> image = texture(160, 120);
  const Measured measured(12);
  PointSet good = random_points(300, 12), mixed;
  mixed.levels = 1;
  for (std::size_t i = 0; i < good.u.size(); ++i) {
    const auto copy = [&](float x, float y, float q, float sigma_q) {
      mixed.push(good.u[i], good.v[i], x, y, q, sigma_q);
      mixed.intensity[0].push_back(good.intensity[0][i]);
    };
    const float x = good.x[i], y = good.y[i], q = good.q[i];
    copy(x, y, kNaN, kNaN);
    copy(x, y, q, good.sigma_q[i]);
    copy(x, y, kInfinity, 1);
    copy(x, y, -50, 1);  // behind the camera
    copy(kNaN, y, q, 1);
    copy(x, -kInfinity, q, 1);
    copy(3e38f, y, q, 1);
    copy(-1e30f, 1e30f, 0, kNaN);
  }
  for (const kernel::Kernels* k : kernel_variants())
    for (const DepthTerm& term : {DepthTerm{}, measured.term}) {
      const KernelReduction reduction{k};
      const AlignState state{motion, 1, 0};
      const NormalEquations of_mixed = reduction.linearize(mixed, 0, camera, image, state, noise, term, nullptr);
      ASSERT_TRUE(of_mixed.H.allFinite()) << k->name;
      for (const auto& mode : of_mixed.modes) ASSERT_TRUE(mode.allFinite()) << k->name;
      expect_same(of_mixed, reduction.linearize(good, 0, camera, image, state, noise, term, nullptr), k->name);
      PointResiduals residuals;
      reduction.residuals(mixed, 0, camera, image, state, noise, term, residuals);
      for (std::size_t i = 0; i < residuals.size(); ++i)
        if (!residuals.seen(i)) {
          EXPECT_EQ(residuals.r[i], 0) << k->name << i;
          EXPECT_EQ(residuals.extra[i], 0) << k->name << i;
          EXPECT_EQ(residuals.value[i], 0) << k->name << i;
        }
    }
}

TEST(Kernel, ImagesTooSmallToSampleShowNothing) {
  const PointSet points = random_points(50, 13);
  for (const kernel::Kernels* k : kernel_variants())
    for (const int size : {1, 3, 4, 5}) {
      const Image<std::uint8_t> image = texture(size, size);
      const KernelReduction reduction{k};
      PointResiduals residuals;
      reduction.residuals(points, 0, camera, image, {}, noise, {}, residuals);
      for (std::size_t i = 0; i < residuals.size(); ++i) EXPECT_EQ(residuals.visibility[i], residuals.seen(i));
      const NormalEquations sums = reduction.linearize(points, 0, camera, image, {}, noise, {}, nullptr);
      EXPECT_TRUE(size == 5 || sums.seen == 0) << k->name;
      EXPECT_EQ(reduction.costs(points, 0, camera, image, nullptr, {}, noise, {}, residuals).seen, sums.seen);
      EXPECT_EQ(reduction.moments(points, 0, camera, image, nullptr, {}, residuals).seen, sums.seen);
    }
}

TEST(Kernel, SumsAreTheSameEveryTime) {
  const Image<std::uint8_t> image = texture(160, 120);
  const PointSet points = random_points(2500, 14);
  for (const kernel::Kernels* k : kernel_variants()) {
    const KernelReduction reduction{k};
    const auto once = [&] { return reduction.linearize(points, 0, camera, image, {motion, 1, 0}, noise, {}, nullptr); };
    const NormalEquations a = once(), b = once();
    EXPECT_EQ(a.H, b.H);
    EXPECT_EQ(a.g, b.g);
    EXPECT_EQ(a.cost, b.cost);
  }
}

TEST(KernelReduction, OtherCamerasGoTheSerialWay) {
  const dot::RadTan radtan(camera.intrinsics(), {-0.2, 0.06, 0.004, -0.003, 0.01});
  const Image<std::uint8_t> image = texture(160, 120);
  const PointSet points = random_points(500, 15);
  const auto got = KernelReduction{}.linearize(points, 0, radtan, image, {motion, 1, 0}, noise, {}, nullptr);
  const auto want = SerialReduction::linearize(points, 0, radtan, image, {motion, 1, 0}, noise, {}, nullptr);
  EXPECT_GT(got.seen, 200);
  EXPECT_EQ(got.H, want.H);
}

TEST(KernelDispatch, FindsByVariantAndByName) {
  ASSERT_NE(dot::find_kernels(KernelVariant::Portable), nullptr);
  EXPECT_STREQ(dot::find_kernels(KernelVariant::Portable)->name, "portable");
  const std::string before = std::getenv("DOT_KERNEL") ? std::getenv("DOT_KERNEL") : "";
  ::setenv("DOT_KERNEL", "", 1);
  const kernel::Kernels* widest = dot::find_kernels();
  for (const KernelVariant v :
       {KernelVariant::Portable, KernelVariant::Avx2, KernelVariant::Avx512, KernelVariant::Neon})
    if (const kernel::Kernels* k = dot::find_kernels(v)) {
      ::setenv("DOT_KERNEL", k->name, 1);
      EXPECT_EQ(dot::find_kernels(), k);
      EXPECT_STREQ(dot::DefaultReduction{}.kernels->name, k->name);  // what a Dot<> of this unit gets
    }
  ::setenv("DOT_KERNEL", "no such", 1);
  EXPECT_EQ(dot::find_kernels(), widest);
  if (before.empty())
    ::unsetenv("DOT_KERNEL");
  else
    ::setenv("DOT_KERNEL", before.c_str(), 1);
}

}  // namespace
