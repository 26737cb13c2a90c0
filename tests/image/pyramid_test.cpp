// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/pyramid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "dot/image/opencv.hpp"
#include "support/random.hpp"

namespace {

using dot::Image;
using dot::Pyramid;
using dot::Sample;

template <typename Function>
Image<std::uint8_t> image_of(int width, int height, Function&& value) {
  Image<std::uint8_t> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image(x, y) = static_cast<std::uint8_t>(value(x, y));
  return image;
}

Image<std::uint8_t> random_image(int width, int height, unsigned seed) {
  dot::test::Random random(seed);
  return image_of(width, height, [&](int, int) { return random.uniform(0, 256); });
}

/// A blur and a mean leave a ramp what it is, so each pixel of a level tells where in level 0 it lies.
void expect_ramp(const Pyramid& pyramid, double by_x, double by_y, double at_origin) {
  for (int l = 0; l < pyramid.size(); ++l) {
    const Image<std::uint8_t>& level = pyramid.levels[static_cast<std::size_t>(l)];
    const double scale = 1 << l;
    // Border pixels see the replicated border through the blur.
    const int border = l == 0 ? 2 : 1;
    for (int y = border; y < level.height() - border; ++y)
      for (int x = border; x < level.width() - border; ++x) {
        const double u = (x + 0.5) * scale - 0.5, v = (y + 0.5) * scale - 0.5;
        // Half a grey value of rounding for the blur and half for each level; without the half pixels of the
        // convention the ramp would be off by (2^l - 1) / 2 of its slope.
        EXPECT_NEAR(level(x, y), by_x * u + by_y * v + at_origin, 0.5 + 0.5 * l + 0.01) << l << ": " << x << ", " << y;
      }
  }
}

TEST(Pyramid, PixelsAreAtTheCentreOfWhatTheyCover) {
  Pyramid pyramid;
  pyramid.build(image_of(80, 64, [](int x, int) { return 3 * x + 5; }).view(), 4);
  expect_ramp(pyramid, 3, 0, 5);
  pyramid.build(image_of(64, 80, [](int, int y) { return 240 - 3 * y; }).view(), 4);
  expect_ramp(pyramid, 0, -3, 240);
}

TEST(Pyramid, OddSizesLoseTheLastPixelsAndStayInPlace) {
  Pyramid pyramid;
  pyramid.build(image_of(79, 45, [](int x, int y) { return 2 * x + 2 * y; }).view(), 4);
  ASSERT_EQ(pyramid.size(), 4);
  const std::pair<int, int> sizes[] = {{79, 45}, {39, 22}, {19, 11}, {9, 5}};
  for (std::size_t l = 0; l < 4; ++l) {
    EXPECT_EQ(pyramid.levels[l].width(), sizes[l].first);
    EXPECT_EQ(pyramid.levels[l].height(), sizes[l].second);
  }
  EXPECT_EQ(pyramid.width(), 79);
  EXPECT_EQ(pyramid.height(), 45);
  expect_ramp(pyramid, 2, 2, 0);
}

TEST(Pyramid, EachLevelIsTheMeanOfFourPixels) {
  Pyramid pyramid;
  pyramid.build(random_image(50, 41, 3).view(), 3);
  for (std::size_t l = 1; l < 3; ++l) {
    const Image<std::uint8_t>& below = pyramid.levels[l - 1];
    const Image<std::uint8_t>& level = pyramid.levels[l];
    for (int y = 0; y < level.height(); ++y)
      for (int x = 0; x < level.width(); ++x) {
        const int x2 = 2 * x, y2 = 2 * y;
        const int sum = below(x2, y2) + below(x2 + 1, y2) + below(x2, y2 + 1) + below(x2 + 1, y2 + 1);
        EXPECT_NEAR(level(x, y), 0.25 * sum, 0.5);
      }
  }
}

TEST(Pyramid, BlurHasItsWidth) {
  for (const double sigma : {0.6, 0.8, 1.0}) {
    Pyramid pyramid;
    pyramid.build(image_of(21, 21, [](int x, int y) { return x == 10 && y == 10 ? 250 : 0; }).view(), 1,
                  dot::portable_kernels(), sigma);
    double sum = 0, second = 0;
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 21; ++x) {
        sum += pyramid.levels[0](x, y);
        second += pyramid.levels[0](x, y) * (x - 10.0) * (x - 10.0);
      }
    // 25 rounded pixels; the kernel ends at two pixels, which takes up to a seventh off its variance.
    EXPECT_NEAR(sum, 250, 12);
    EXPECT_NEAR(std::sqrt(second / sum), sigma, 0.1 * sigma);
  }
}

// OpenCV rounds its weights to 1/256 and its sums once, too.
TEST(Pyramid, IsThatOfOpenCvToTheBit) {
  for (const auto& [width, height] : {std::pair{99, 61}, {1, 1}, {2, 3}, {1100, 5}, {1026, 4}})
    for (const double sigma : {0.5, 0.8, 1.0, 1.3, 2.0}) {
      const Image<std::uint8_t> grey = random_image(width, height, 8);
      const int levels = width > 50 && height > 50 ? 4 : 1;
      Pyramid pyramid;
      pyramid.build(grey.view(), levels, dot::portable_kernels(), sigma);
      cv::Mat expected;
      cv::GaussianBlur(dot::mat(grey.view()), expected, cv::Size(5, 5), sigma, sigma, cv::BORDER_REPLICATE);
      for (const Image<std::uint8_t>& level : pyramid.levels) {
        if (&level != &pyramid.levels[0]) {
          const cv::Mat even = expected(cv::Rect(0, 0, 2 * level.width(), 2 * level.height()));
          cv::Mat half;
          cv::resize(even, half, cv::Size(level.width(), level.height()), 0, 0, cv::INTER_AREA);
          expected = half;
        }
        EXPECT_EQ(cv::norm(dot::mat(level.view()), expected, cv::NORM_INF), 0) << sigma << ", " << level.width();
      }
    }
}

TEST(Pyramid, TakesStridedViewsAndBuildsAnew) {
  const Image<std::uint8_t> large = random_image(120, 90, 4);
  const dot::ImageView<const std::uint8_t> part{large.row(7) + 9, 66, 50, large.width()};
  Image<std::uint8_t> packed = image_of(66, 50, [&](int x, int y) { return large(x + 9, y + 7); });
  Pyramid strided, reused;
  strided.build(part, 3);
  reused.build(large.view(), 4);
  reused.build(packed.view(), 3);
  ASSERT_EQ(reused.size(), 3);
  for (std::size_t l = 0; l < 3; ++l) {
    ASSERT_EQ(strided.levels[l].width(), reused.levels[l].width());
    ASSERT_EQ(strided.levels[l].height(), reused.levels[l].height());
    for (int y = 0; y < strided.levels[l].height(); ++y)
      for (int x = 0; x < strided.levels[l].width(); ++x)
        ASSERT_EQ(strided.levels[l](x, y), reused.levels[l](x, y)) << l << ": " << x << ", " << y;
  }
}

TEST(PyramidLevels, LeaveTheCoarsestAboutEightyPixelsWide) {
  for (int width = 16; width < 3000; width += 37)
    for (const int height : {width / 4 + 16, width}) {
      const int levels = dot::pyramid_levels(width, height, 6);
      ASSERT_GE(levels, 1);
      ASSERT_LE(levels, 6);
      if (levels > 1) {
        EXPECT_GE(width >> (levels - 1), 60);
        EXPECT_GE(height >> (levels - 1), 20);
      }
      if (levels < 6) {
        EXPECT_TRUE(width >> levels < 80 || height >> levels < 20) << width;
      }
    }
  EXPECT_EQ(dot::pyramid_levels(1242, 375, 2), 2);
  EXPECT_EQ(dot::pyramid_levels(16, 16, 5), 1);
}

TEST(PyramidSample, IsBilinear) {
  const Image<std::uint8_t> image = random_image(12, 10, 5);
  for (int y = 1; y < 8; ++y)
    for (int x = 1; x < 10; ++x) {
      EXPECT_EQ(sample(image, static_cast<float>(x), static_cast<float>(y)).value, image(x, y));
      const float a = 0.25f, b = 0.625f;
      const float expected = (1 - b) * ((1 - a) * image(x, y) + a * image(x + 1, y)) +
                             b * ((1 - a) * image(x, y + 1) + a * image(x + 1, y + 1));
      EXPECT_NEAR(sample(image, static_cast<float>(x) + a, static_cast<float>(y) + b).value, expected, 1e-3);
    }
}

TEST(PyramidSample, GradientIsTheDerivativeOverTwoPixels) {
  const Image<std::uint8_t> image = random_image(16, 14, 6);
  dot::test::Random random(7);
  for (int i = 0; i < 500; ++i) {
    const auto u = static_cast<float>(random.uniform(2, 12.9)), v = static_cast<float>(random.uniform(2, 10.9));
    const Sample s = sample(image, u, v);
    EXPECT_NEAR(s.gx, 0.5f * (sample(image, u + 1, v).value - sample(image, u - 1, v).value), 2e-3);
    EXPECT_NEAR(s.gy, 0.5f * (sample(image, u, v + 1).value - sample(image, u, v - 1).value), 2e-3);
  }
}

TEST(PyramidSample, GradientIsThatOfAParabola) {
  // Central differences are exact for it, and so is their interpolation.
  const Image<std::uint8_t> image = image_of(17, 9, [](int x, int y) { return (x - 8) * (x - 8) + x * y + 2 * y; });
  for (float v = 1; v < 6.95f; v += 0.37f)
    for (float u = 1; u < 14.95f; u += 0.41f) {
      const Sample s = sample(image, u, v);
      EXPECT_NEAR(s.gx, 2 * (u - 8) + v, 1e-4);
      EXPECT_NEAR(s.gy, u + 2, 1e-4);
    }
}

}  // namespace
