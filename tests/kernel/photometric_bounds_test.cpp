// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <utility>

#include "support/guarded.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

/// @file
/// Kernels read nothing before the first byte of their inputs nor past the last, and write nothing past their outputs:
/// each array lies against pages that may not be touched.

namespace {

namespace kernel = dot::kernel;
using dot::test::Guarded;
using dot::test::kernel_variants;
using dot::test::Random;

TEST(KernelBounds, ReadAndWriteWithinTheArrays) {
  constexpr int kWidth = 37, kHeight = 29, kOccludersStride = 41;
  for (const bool at_the_end : {true, false})
    for (const int n : {1, 2, 7, 8, 9, 15, 16, 17, 130, 3000}) {
      const auto count = static_cast<std::size_t>(n);
      const Guarded x(4 * count, at_the_end), y(4 * count, at_the_end), q(4 * count, at_the_end);
      const Guarded sigma_q(4 * count, at_the_end), intensity(4 * count, at_the_end), u(4 * count, at_the_end);
      const Guarded v(4 * count, at_the_end), gu(4 * count, at_the_end), gv(4 * count, at_the_end);
      const Guarded excluded(count, at_the_end);
      const Guarded image(kWidth * kHeight, at_the_end), depth_image(4 * kWidth * kHeight, at_the_end);
      const Guarded occluders(kOccludersStride * (kHeight - 1) + kWidth, at_the_end);
      const Guarded r(4 * count, at_the_end), extra(4 * count, at_the_end), value(4 * count, at_the_end);
      const Guarded r_depth(4 * count, at_the_end), visibility(count, at_the_end);
      Random random(static_cast<unsigned>(n));
      for (int i = 0; i < kWidth * kHeight; ++i) {
        image.bytes()[i] = static_cast<unsigned char>(random.uniform(0, 256));
        depth_image.floats()[i] = static_cast<float>(random.uniform(0, 1));
      }
      std::memset(occluders.bytes(), 0, kOccludersStride * (kHeight - 1) + kWidth);
      // The identity of a camera of focal length one: the rays are the pixels, among them the outermost that are seen
      // and many beyond.
      for (int i = 0; i < n; ++i) {
        u.floats()[i] = x.floats()[i] = i % 3 ? static_cast<float>(random.uniform(-9, kWidth + 9)) : kWidth - 3.01f;
        v.floats()[i] = y.floats()[i] = i % 5 ? static_cast<float>(random.uniform(-9, kHeight + 9)) : kHeight - 3.01f;
        if (i % 7 == 0) x.floats()[i] = y.floats()[i] = 1;
        q.floats()[i] = sigma_q.floats()[i] = 0.5f;
        intensity.floats()[i] = 100;
        gu.floats()[i] = gv.floats()[i] = 3;
        excluded.bytes()[i] = i % 13 == 5;
      }
      kernel::Input in;
      kernel::Points& p = in.points;
      p.n = n;
      p.x = x.floats(), p.y = y.floats(), p.q = q.floats(), p.sigma_q = sigma_q.floats();
      p.intensity = intensity.floats(), p.gu = gu.floats(), p.gv = gv.floats(), p.u = u.floats(), p.v = v.floats();
      p.excluded = excluded.bytes();
      in.level = {image.bytes(), kWidth, kHeight, kWidth};
      kernel::Depth depth;
      depth.data = depth_image.floats();
      depth.width = kWidth, depth.height = kHeight, depth.stride = 4 * kWidth;
      depth.occluders = occluders.bytes();
      depth.occluders_width = kWidth, depth.occluders_height = kHeight, depth.occluders_stride = kOccludersStride;
      depth.occlusion_relative = 10, depth.occlusion_absolute = 10, depth.sigma = 0.1f, depth.weight = 1;
      for (const kernel::Kernels* k : kernel_variants())
        for (const kernel::Depth* term : {static_cast<const kernel::Depth*>(nullptr), &std::as_const(depth)})
          // With the larger scale the outermost points see the corners of depth and mask, and beyond.
          for (const float scale : {1.f, 1.06f}) {
            depth.scale = depth.occluders_scale = scale;
            in.depth = term;
            in.gradient = scale > 1 ? dot::GradientSource::Mean : dot::GradientSource::Reference;
            kernel::Sums sums;
            k->linearize(in, sums);
            EXPECT_GT(sums.seen, 0) << k->name;
            k->residuals(in, {r.floats(), extra.floats(), value.floats(), r_depth.floats(), visibility.bytes()});
            int seen = 0;
            for (int i = 0; i < n; ++i) seen += visibility.bytes()[i] & kernel::kSeen;
            EXPECT_EQ(seen, sums.seen) << k->name;
          }
    }
}

TEST(KernelBounds, ImagesTooSmallToSampleAreNotRead) {
  const Guarded image(8, false);  // it is before the first byte that a clamped coordinate would lead
  const float at[3] = {0, 1, 2}, zero[3] = {};
  float r[3], extra[3], value[3], r_depth[3];
  unsigned char visibility[3];
  for (const kernel::Kernels* k : kernel_variants())
    for (const auto& [width, height] : {std::pair{1, 8}, {8, 1}, {4, 2}, {2, 4}, {0, 0}}) {
      kernel::Input in;
      in.points = {3, at, at, zero, zero, zero, zero, zero, at, at, nullptr};
      in.level = {image.bytes(), width, height, width};
      kernel::Sums sums;
      k->linearize(in, sums);
      EXPECT_EQ(sums.seen, 0) << k->name;
      std::memset(visibility, 255, sizeof visibility);
      k->residuals(in, {r, extra, value, r_depth, visibility});
      EXPECT_EQ(visibility[0] | visibility[1] | visibility[2], 0) << k->name;
    }
}

TEST(KernelBounds, TheLastByteOfTheMaskCounts) {
  constexpr int kSize = 12;
  const Guarded image(kSize * kSize, true), depth_image(4 * kSize * kSize, true), occluders(kSize * kSize, true);
  std::memset(image.bytes(), 50, kSize * kSize);
  std::memset(depth_image.bytes(), 0, 4 * kSize * kSize);
  const float at = kSize - 3.25f, zero = 0, one = 1;
  kernel::Input in;
  in.points = {1, &at, &at, &one, &zero, &zero, &zero, &zero, &at, &at, nullptr};
  in.level = {image.bytes(), kSize, kSize, kSize};
  kernel::Depth depth;
  depth.data = depth_image.floats();
  depth.width = depth.height = kSize, depth.stride = 4 * kSize;
  depth.occluders = occluders.bytes();
  depth.occluders_width = depth.occluders_height = kSize, depth.occluders_stride = kSize;
  depth.occluders_scale = 11.5f / (at + 0.5f);  // to the middle of the last pixel
  in.depth = &depth;
  for (const kernel::Kernels* k : kernel_variants()) {
    kernel::Sums sums;
    std::memset(occluders.bytes(), 255, kSize * kSize);
    occluders.bytes()[kSize * kSize - 1] = 0;
    k->linearize(in, sums);
    EXPECT_EQ(sums.seen, 1) << k->name;
    std::memset(occluders.bytes(), 0, kSize * kSize);
    occluders.bytes()[kSize * kSize - 1] = 1;
    k->linearize(in, sums);
    EXPECT_EQ(sums.occluded, 1) << k->name;
  }
}

}  // namespace
