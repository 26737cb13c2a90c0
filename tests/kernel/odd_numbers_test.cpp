// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dot/kernel/kernels.hpp"
#include "support/kernel_variants.hpp"

/// @file
/// Processors differ in what they make of NaN (minimum, maximum), of numbers beyond the integers (conversion), and of
/// denormal numbers. The kernels do not.

namespace {

namespace kernel = dot::kernel;
using dot::test::kernel_variants;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
constexpr float tiny = 4e-42f;  // denormal
constexpr int kLanes = 16;      // the most of any variant

TEST(OddNumbers, DenormalsAreNotZero) {
  float q[2 * kLanes], none[2 * kLanes] = {}, out[kLanes];
  for (float& each : q) each = tiny;
  for (const kernel::Kernels* k : kernel_variants()) {
    k->invert_floats(q, kLanes, {1e-20f, 0, 1}, out);
    for (const float got : out) EXPECT_EQ(got, 1e-20f / tiny) << k->name;
    k->halve_depth(q, q, kLanes, out);
    for (const float got : out) EXPECT_EQ(got, tiny) << k->name;
    k->take_bias(q, kLanes, {none, none, 0, 0}, out);
    for (const float got : out) EXPECT_EQ(got, tiny) << k->name;
  }
}

TEST(OddNumbers, TheMaximumOfNanAndANumberIsTheNumber) {
  float q[kLanes], base[kLanes], slope[kLanes] = {}, out[kLanes];
  for (int i = 0; i < kLanes; ++i) q[i] = 0.5f, base[i] = i % 3 ? nan : 0.125f;
  for (const kernel::Kernels* k : kernel_variants()) {
    k->take_bias(q, kLanes, {base, slope, 0, 0.25f}, out);
    for (int i = 0; i < kLanes; ++i) EXPECT_EQ(out[i], i % 3 ? 0.25f : 0.375f) << k->name;
  }
}

TEST(OddNumbers, PointsFarFromTheImageAreSampledAtItsBorder) {
  constexpr int kSize = 8;
  unsigned char image[kSize * kSize];
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) image[kSize * y + x] = static_cast<unsigned char>(10 * x);
  const float odd[] = {nan, -infinity, -1e30f, -3e9f, -1, 3e9f, 1e30f, infinity};
  constexpr int n = sizeof odd / sizeof *odd;
  float v[n], value[n], gu[n], gv[n];
  for (float& each : v) each = 3;
  for (const kernel::Kernels* k : kernel_variants()) {
    k->sample({image, kSize, kSize, kSize}, 1, odd, v, n, {value, gu, gv});
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(value[i], odd[i] > 0 ? 59.9f : 10, 1e-4) << k->name << ": " << odd[i];
      EXPECT_NEAR(gu[i], 10, 1e-4) << k->name << ": " << odd[i];
      EXPECT_EQ(gv[i], 0) << k->name << ": " << odd[i];
    }
  }
}

TEST(OddNumbers, PointsOfNoPlaceAreNotSeen) {
  constexpr int kSize = 16;
  unsigned char image[kSize * kSize];
  for (int i = 0; i < kSize * kSize; ++i) image[i] = static_cast<unsigned char>(i % 251);
  // A camera of focal length one at the identity but for its shift: the rays are the pixels. The last point is seen.
  const float odd[] = {nan, infinity, -infinity, 1e30f, -1e30f, 3e9f, -3e9f, tiny, 5};
  constexpr int n = sizeof odd / sizeof *odd;
  const float five[n] = {5, 5, 5, 5, 5, 5, 5, 5, 5}, half[n] = {.5f, .5f, .5f, .5f, .5f, .5f, .5f, .5f, .5f};
  float inverse_depth[kSize * kSize];
  for (float& q : inverse_depth) q = 0.5f;
  kernel::Depth depth;
  depth.data = inverse_depth, depth.width = depth.height = kSize, depth.stride = 4 * kSize;
  depth.occlusion_relative = 10, depth.occlusion_absolute = 10, depth.sigma = 0.1f, depth.weight = 1;
  kernel::Input in;
  in.level = {image, kSize, kSize, kSize};
  in.depth = &depth;
  for (const kernel::Kernels* k : kernel_variants())
    for (const bool along_x : {true, false})
      for (const float z_shift : {0.f, -2.f, nan}) {  // a shift by -2 m puts a point at 2 m into the camera
        const float *x = along_x ? odd : five, *y = along_x ? five : odd;
        in.points = {n, x, y, half, half, five, five, five, five, five, nullptr};
        in.view.t[2] = z_shift;
        kernel::Sums sums;
        k->linearize(in, sums);
        EXPECT_EQ(sums.seen, z_shift == 0) << k->name;
        EXPECT_TRUE(std::isfinite(sums.cost)) << k->name;
        for (const double h : sums.H) EXPECT_TRUE(std::isfinite(h)) << k->name;
        float r[n], extra[n], value[n], r_depth[n];
        unsigned char visibility[n];
        k->residuals(in, {r, extra, value, r_depth, visibility});
        for (int i = 0; i < n; ++i) {
          const bool seen = z_shift == 0 && i == n - 1;
          EXPECT_EQ(visibility[i], seen ? kernel::kSeen | kernel::kHasDepth : 0) << k->name << ": " << odd[i];
          EXPECT_EQ(value[i] == 0, !seen) << k->name << ": " << odd[i];
        }
      }
}

}  // namespace
