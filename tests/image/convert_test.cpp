// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/convert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace {

using dot::Image;
using dot::ImageRef;
using dot::PixelFormat;

/// Random pixels of a colour format, each row followed by bytes that belong to no pixel.
struct Coloured {
  static constexpr int width = 13, height = 7, padding = 5;
  std::vector<std::uint8_t> bytes;
  ImageRef ref;

  Coloured(PixelFormat format, unsigned seed) {
    dot::test::Random random(seed);
    const int stride = width * dot::bytes_per_pixel(format) + padding;
    bytes.resize(static_cast<std::size_t>(stride * height));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform(0, 256));
    ref = {bytes.data(), width, height, stride, format};
  }
  std::uint8_t channel(int x, int y, int c) const {
    return bytes[static_cast<std::size_t>(y * ref.stride + x * dot::bytes_per_pixel(ref.format) + c)];
  }
};

void to_grey(const ImageRef& image, Image<std::uint8_t>& grey) {
  grey.resize(image.width, image.height);
  Image<std::uint8_t> scratch;
  dot::GreyRows rows(image, scratch);
  for (int y = 0; y < image.height; ++y) std::copy_n(rows(y), image.width, grey.row(y));
}

void to_inverse_depth(const ImageRef& depth, double max_depth, Image<float>& q) {
  q.resize(depth.width, depth.height);
  const dot::InverseDepthRows rows(depth, max_depth);
  for (int y = 0; y < depth.height; ++y) rows(y, q.row(y));
}

/// Luminance of ITU-R BT.601.
double luminance(double red, double green, double blue) { return 0.299 * red + 0.587 * green + 0.114 * blue; }

struct ColourOrder {
  PixelFormat format;
  int red, green, blue;
};

class GreyRows : public ::testing::TestWithParam<ColourOrder> {};

TEST_P(GreyRows, WeighsTheRightChannels) {
  const ColourOrder order = GetParam();
  const Coloured image(order.format, 11);
  Image<std::uint8_t> grey;
  to_grey(image.ref, grey);
  ASSERT_EQ(grey.width(), Coloured::width);
  ASSERT_EQ(grey.height(), Coloured::height);
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < grey.width(); ++x) {
      const double expected =
          luminance(image.channel(x, y, order.red), image.channel(x, y, order.green), image.channel(x, y, order.blue));
      EXPECT_NEAR(grey(x, y), expected, 1.0) << x << ", " << y;  // one: rounding, in fixed point
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, GreyRows,
                         ::testing::Values(ColourOrder{PixelFormat::Bgr8, 2, 1, 0},
                                           ColourOrder{PixelFormat::Rgb8, 0, 1, 2},
                                           ColourOrder{PixelFormat::Bgra8, 2, 1, 0}));

TEST(GreyRowsOfGrey, AreThose) {
  const Coloured image(PixelFormat::Grey8, 12);
  Image<std::uint8_t> grey(100, 90);  // of another frame
  to_grey(image.ref, grey);
  ASSERT_EQ(grey.width(), Coloured::width);
  ASSERT_EQ(grey.height(), Coloured::height);
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < grey.width(); ++x) EXPECT_EQ(grey(x, y), image.channel(x, y, 0));
}

TEST(GreyRowsOfColour, IgnoresAlpha) {
  Coloured image(PixelFormat::Bgra8, 13);
  Image<std::uint8_t> before, after;
  to_grey(image.ref, before);
  for (int y = 0; y < Coloured::height; ++y)
    for (int x = 0; x < Coloured::width; ++x) {
      std::uint8_t& alpha = image.bytes[static_cast<std::size_t>(y * image.ref.stride + x * 4 + 3)];
      alpha = static_cast<std::uint8_t>(255 - alpha);
    }
  to_grey(image.ref, after);
  for (int y = 0; y < Coloured::height; ++y)
    for (int x = 0; x < Coloured::width; ++x) EXPECT_EQ(before(x, y), after(x, y));
}

// They are made some at a time: none is overwritten too early, and the last few are made too.
TEST(GreyRowsOfColour, LastAsLongAsPromised) {
  constexpr int width = 3, height = 3 * dot::GreyRows::kAtOnce + 5;
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < height; ++y) bytes.insert(bytes.end(), 3 * width, static_cast<std::uint8_t>(2 * y));
  Image<std::uint8_t> scratch;
  dot::GreyRows rows({bytes.data(), width, height, 3 * width, PixelFormat::Bgr8}, scratch);
  for (int y = 0; y < height; ++y) {
    EXPECT_EQ(rows(y)[width - 1], 2 * y);
    const int before = std::max(0, y - dot::GreyRows::kAtOnce);
    EXPECT_EQ(rows(before)[0], 2 * before);
  }
}

int measured(const Image<float>& q) {
  return static_cast<int>(std::count_if(q.row(0), q.row(q.height()), [](float v) { return v > 0; }));
}

TEST(InverseDepthRows, OfMetres) {
  const std::vector<float> metres{0.5f, 1, 2, 8, 79.9f, 3};
  Image<float> q;
  to_inverse_depth({metres.data(), 3, 2, 12, PixelFormat::DepthF32}, 80, q);
  EXPECT_EQ(measured(q), 6);
  for (int i = 0; i < 6; ++i) EXPECT_FLOAT_EQ(q(i % 3, i / 3), 1 / metres[static_cast<std::size_t>(i)]);
}

TEST(InverseDepthRows, WhatIsNoMeasurementIsZero) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> metres{0, -0.f, -1, -infinity, infinity, nan, -nan, 80, 80.1f, 1e30f, 40};
  Image<float> q;
  const int width = static_cast<int>(metres.size());
  to_inverse_depth({metres.data(), width, 1, width * 4, PixelFormat::DepthF32}, 80, q);
  EXPECT_EQ(measured(q), 1);
  for (int x = 0; x + 1 < width; ++x) EXPECT_EQ(q(x, 0), 0) << metres[static_cast<std::size_t>(x)];
  EXPECT_FLOAT_EQ(q(width - 1, 0), 0.025f);
}

TEST(InverseDepthRows, SixteenBitsHaveTheirUnit) {
  const std::vector<std::uint16_t> values{0, 500, 2560, 65535};
  Image<float> q;
  ImageRef depth{values.data(), 4, 1, 8, PixelFormat::DepthU16};
  to_inverse_depth(depth, 80, q);
  EXPECT_EQ(measured(q), 2);  // 1000 a metre by default
  EXPECT_EQ(q(0, 0), 0);
  EXPECT_FLOAT_EQ(q(1, 0), 2);
  EXPECT_FLOAT_EQ(q(2, 0), 1000.f / 2560);
  EXPECT_EQ(q(3, 0), 0);  // never a measurement
  depth.depth_units_per_metre = 256;
  to_inverse_depth(depth, 80, q);
  EXPECT_EQ(measured(q), 2);
  EXPECT_FLOAT_EQ(q(1, 0), 256.f / 500);
  EXPECT_FLOAT_EQ(q(2, 0), 0.1f);
  to_inverse_depth(depth, 2, q);
  EXPECT_EQ(measured(q), 1);  // 10 m is too far
}

TEST(UnbiasedDepthRows, LosesTheBiasOfItsPlace) {
  constexpr int width = 40, height = 20;
  std::vector<float> metres(width * height, 4.f);
  metres[3] = 0, metres[width] = 50;
  const ImageRef depth{metres.data(), width, height, width * 4, PixelFormat::DepthF32};
  dot::DepthBias bias;
  bias.coefficients << 0.02, -0.03, 0.04, 0.01, -0.02, 0.03, 0.05;
  Image<float> rows;
  dot::UnbiasedDepthRows unbiased(dot::InverseDepthRows(depth, 60), 80, bias, rows);
  std::vector<float> row(width);
  for (int y = 0; y < height; ++y) {
    unbiased(y, row.data());
    for (int x = 0; x < width; ++x) {
      const double measured = 1 / static_cast<double>(metres[static_cast<std::size_t>(y * width + x)]);
      const double q = std::max(1.0 / 80, measured - bias(2.0 * x / width - 1, 2.0 * y / height - 1));
      ASSERT_NEAR(row[static_cast<std::size_t>(x)], x == 3 && y == 0 ? 0 : q, 1e-6) << x << ", " << y;
    }
  }
}

TEST(InverseDepthRows, ObeysTheStride) {
  const std::vector<float> metres{1, 2, -7, 4, 5, -7};
  Image<float> q;
  to_inverse_depth({metres.data(), 2, 2, 12, PixelFormat::DepthF32}, 80, q);
  EXPECT_EQ(measured(q), 4);
  EXPECT_FLOAT_EQ(q(0, 1), 0.25f);
  EXPECT_FLOAT_EQ(q(1, 1), 0.2f);
  const std::vector<std::uint16_t> values{100, 200, 9, 9, 400, 500, 9, 9};
  to_inverse_depth({values.data(), 2, 2, 8, PixelFormat::DepthU16, 100}, 80, q);
  EXPECT_EQ(measured(q), 4);
  EXPECT_FLOAT_EQ(q(0, 1), 0.25f);
  EXPECT_FLOAT_EQ(q(1, 1), 0.2f);
}

}  // namespace
