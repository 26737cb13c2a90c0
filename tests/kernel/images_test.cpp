// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/kernel/images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <limits>
#include <utility>

#include "support/guarded.hpp"
#include "support/kernel_variants.hpp"
#include "support/random.hpp"

/// @file
/// Every kernel of this machine gives the same rows, to the bit or to float rounding, whatever their length, and
/// touches nothing beyond them: each lies against a page that may not be touched.

namespace {

namespace kernel = dot::kernel;
using dot::test::Guarded;
using dot::test::kernel_variants;
using dot::test::Random;

constexpr int lengths[] = {1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 100, 1023, 1024, 1025, 1026, 1027, 2050};

TEST(ImageKernels, InvertDepth) {
  Random random(1);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const float odd[] = {0, -0.f, -1, nan, infinity, -infinity, 0.001f, 80, 79.99f, 1e-30f};
  for (const bool at_the_end : {true, false})
    for (const int n : lengths) {
      const auto size = static_cast<std::size_t>(n);
      const Guarded metres(4 * size, at_the_end), words(2 * size, at_the_end), out(4 * size, at_the_end);
      auto* const values = reinterpret_cast<unsigned short*>(words.bytes());
      for (int i = 0; i < n; ++i) {
        metres.floats()[i] = random.uniform() < 0.3 ? odd[static_cast<int>(random.uniform(0, 10))]
                                                    : static_cast<float>(random.uniform(0, 90));
        values[i] = static_cast<unsigned short>(random.uniform() < 0.2 ? 0 : random.uniform(0, 65536));
      }
      const kernel::DepthUnits in_metres{1, 0.001f, 80}, in_words{256, 0.256f, 80 * 256};
      for (const kernel::Kernels* k : kernel_variants()) {
        k->invert_floats(metres.floats(), n, in_metres, out.floats());
        for (int i = 0; i < n; ++i) {
          const float z = metres.floats()[i];
          ASSERT_EQ(out.floats()[i], z > 0.001f && z < 80 ? 1 / z : 0) << k->name << ": " << z;
        }
        k->invert_words(values, n, in_words, out.floats());
        for (int i = 0; i < n; ++i) {
          const auto z = static_cast<float>(values[i]);
          ASSERT_EQ(out.floats()[i], z > 0.256f && z < 80 * 256 ? 256 / z : 0) << k->name << ": " << z;
        }
      }
    }
}

// A host may have the processor trap divisions by zero; pixels without depth are in each frame.
TEST(ImageKernels, DivideByNoHole) {
  float metres[37] = {}, out[37];
  unsigned short words[37] = {};
  metres[5] = 1e-42f, metres[7] = 2, metres[30] = -1, words[7] = 512, words[36] = 65535;
  for (const kernel::Kernels* k : kernel_variants()) {
    std::feclearexcept(FE_ALL_EXCEPT);
    k->invert_floats(metres, 37, {1, 0.001f, 80}, out);
    EXPECT_EQ(out[7], 0.5f) << k->name;
    k->invert_words(words, 37, {256, 0.256f, 80 * 256}, out);
    EXPECT_EQ(out[7], 0.5f) << k->name;
    EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_OVERFLOW | FE_INVALID), 0) << k->name;
  }
}

TEST(ImageKernels, TakeBias) {
  Random random(6);
  for (const bool at_the_end : {true, false})
    for (const int n : lengths) {
      const auto size = static_cast<std::size_t>(n);
      const Guarded q(4 * size, at_the_end), base(4 * size, at_the_end), slope(4 * size, at_the_end);
      const Guarded out(4 * size, at_the_end);
      for (int i = 0; i < n; ++i) {
        q.floats()[i] = random.uniform() < 0.3 ? 0 : static_cast<float>(random.uniform(0, 0.5));
        base.floats()[i] = static_cast<float>(random.uniform(-0.2, 0.2));
        slope.floats()[i] = static_cast<float>(random.uniform(-0.2, 0.2));
      }
      for (const kernel::Kernels* k : kernel_variants()) {
        k->take_bias(q.floats(), n, {base.floats(), slope.floats(), -0.5f, 0.01f}, out.floats());
        for (int i = 0; i < n; ++i) {
          const float without = q.floats()[i] - (base.floats()[i] - 0.5f * slope.floats()[i]);
          ASSERT_NEAR(out.floats()[i], q.floats()[i] > 0 ? std::max(without, 0.01f) : 0, 1e-7) << k->name;
        }
      }
    }
}

TEST(ImageKernels, HalveDepth) {
  Random random(2);
  for (const bool at_the_end : {true, false})
    for (const int n : lengths) {
      const auto size = static_cast<std::size_t>(n);
      const Guarded upper(8 * size, at_the_end), lower(8 * size, at_the_end), out(4 * size, at_the_end);
      for (const Guarded* row : {&upper, &lower})
        for (int i = 0; i < 2 * n; ++i) {
          const float surfaces[] = {0, 0.2f, 0.21f, 0.19f, 0.5f};
          row->floats()[i] = surfaces[static_cast<int>(random.uniform(0, 5))];
        }
      for (const kernel::Kernels* k : kernel_variants()) {
        k->halve_depth(upper.floats(), lower.floats(), n, out.floats());
        for (int i = 0; i < n; ++i) {
          const float q[] = {upper.floats()[2 * i], upper.floats()[2 * i + 1], lower.floats()[2 * i],
                             lower.floats()[2 * i + 1]};
          const float limit = 0.9f * *std::max_element(q, q + 4);
          float sum = 0, count = 0;
          for (const float v : q)
            if (v > 0 && v >= limit) sum += v, count += 1;
          ASSERT_EQ(out.floats()[i], count > 0 ? sum / count : 0) << k->name;
        }
      }
    }
}

TEST(ImageKernels, Blur) {
  Random random(3);
  for (const bool at_the_end : {true, false})
    for (const int n : lengths) {
      const auto size = static_cast<std::size_t>(n);
      const Guarded r0(size, at_the_end), r1(size, at_the_end), r2(size, at_the_end), r3(size, at_the_end);
      const Guarded r4(size, at_the_end), out(size, at_the_end);
      const unsigned char* const rows[] = {r0.bytes(), r1.bytes(), r2.bytes(), r3.bytes(), r4.bytes()};
      for (const bool white : {false, true})  // all at the greatest value: no sum may overflow
        for (const kernel::BlurWeights w : {kernel::BlurWeights{128, 58, 6}, {256, 0, 0}, {52, 51, 51}}) {
          for (const Guarded* row : {&r0, &r1, &r2, &r3, &r4})
            for (int i = 0; i < n; ++i)
              row->bytes()[i] = static_cast<unsigned char>(white ? 255 : random.uniform(0, 256));
          const int of[] = {w.outer, w.next, w.middle, w.next, w.outer};
          for (const kernel::Kernels* k : kernel_variants()) {
            k->blur(rows, n, w, out.bytes());
            for (int x = 0; x < n; ++x) {
              int sum = 0;
              for (int i = 0; i < 5; ++i)
                for (int j = 0; j < 5; ++j) sum += of[i] * of[j] * rows[i][std::clamp(x + j - 2, 0, n - 1)];
              ASSERT_EQ(out.bytes()[x], (sum + 32768) >> 16) << k->name << ": " << x << " of " << n;
            }
          }
        }
    }
}

TEST(ImageKernels, Halve) {
  Random random(4);
  for (const int n : lengths) {
    const auto size = static_cast<std::size_t>(n);
    const Guarded upper(2 * size, true), lower(2 * size, true), out(size, true);
    for (const Guarded* row : {&upper, &lower})
      for (int i = 0; i < 2 * n; ++i) row->bytes()[i] = static_cast<unsigned char>(random.uniform(250, 256));
    for (const kernel::Kernels* k : kernel_variants()) {
      k->halve(upper.bytes(), lower.bytes(), n, out.bytes());
      for (int i = 0; i < n; ++i) {
        const int sum =
            upper.bytes()[2 * i] + upper.bytes()[2 * i + 1] + lower.bytes()[2 * i] + lower.bytes()[2 * i + 1];
        ASSERT_EQ(out.bytes()[i], (sum + 2) / 4) << k->name;
      }
    }
  }
}

/// As image/pyramid.hpp's `sample`, of a point moved inside; in double.
double expected_value(const kernel::Level& level, double u, double v, double* gu, double* gv) {
  u = std::clamp(u, 1.0, level.width - 2.01), v = std::clamp(v, 1.0, level.height - 2.01);
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const double a = u - x, b = v - y;
  const auto bilinear = [&](int dx, int dy) {
    const auto at = [&](int i, int j) {
      return static_cast<double>(level.data[(y + dy + j) * level.stride + x + dx + i]);
    };
    return (1 - b) * ((1 - a) * at(0, 0) + a * at(1, 0)) + b * ((1 - a) * at(0, 1) + a * at(1, 1));
  };
  *gu = 0.5 * (bilinear(1, 0) - bilinear(-1, 0)), *gv = 0.5 * (bilinear(0, 1) - bilinear(0, -1));
  return bilinear(0, 0);
}

// To 0.05 grey values: a coordinate of a float pixel is good to 1e-4, and neighbours differ by up to 255.
TEST(ImageKernels, SampleWithinTheImage) {
  Random random(5);
  for (const bool at_the_end : {true, false})
    for (const auto& [width, height] : {std::pair{4, 4}, {37, 29}})
      for (const int n : lengths) {
        constexpr int kPadding = 5;
        const int stride = width + kPadding;
        const auto size = static_cast<std::size_t>(n);
        const Guarded image(static_cast<std::size_t>(stride * (height - 1) + width), at_the_end);
        const Guarded u(4 * size, at_the_end), v(4 * size, at_the_end), value(4 * size, at_the_end);
        const Guarded gu(4 * size, at_the_end), gv(4 * size, at_the_end);
        for (int i = 0; i < stride * (height - 1) + width; ++i)
          image.bytes()[i] = static_cast<unsigned char>(random.uniform(0, 256));
        for (int i = 0; i < n; ++i) {
          u.floats()[i] = static_cast<float>(random.uniform(-9, 4 * width + 9));
          v.floats()[i] = static_cast<float>(random.uniform(-9, 4 * height + 9));
        }
        const kernel::Level level{image.bytes(), width, height, stride};
        for (const kernel::Kernels* k : kernel_variants()) {
          k->sample(level, 0.25f, u.floats(), v.floats(), n, {value.floats(), gu.floats(), gv.floats()});
          for (int i = 0; i < n; ++i) {
            const double x = 0.25 * (static_cast<double>(u.floats()[i]) + 0.5) - 0.5;
            const double y = 0.25 * (static_cast<double>(v.floats()[i]) + 0.5) - 0.5;
            double dx = 0, dy = 0;
            ASSERT_NEAR(value.floats()[i], expected_value(level, x, y, &dx, &dy), 0.05) << k->name;
            ASSERT_NEAR(gu.floats()[i], dx, 0.05) << k->name;
            ASSERT_NEAR(gv.floats()[i], dy, 0.05) << k->name;
          }
        }
      }
}

}  // namespace
