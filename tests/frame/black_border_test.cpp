// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/black_border.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>

#include <gtest/gtest.h>

#include "support/synthetic_scene.hpp"

namespace {

using dot::BlackBorder;
using dot::Image;
using dot::test::Texture;

constexpr int kWidth = 160, kHeight = 120, kEnd = 6;

/// A picture in a border that is black, as blurred by a pyramid.
struct Picture {
  Image<std::uint8_t> grey{kWidth, kHeight};
  Image<float> inverse_depth{kWidth, kHeight};

  /// @param shows shows(x, y): the pixel is of the picture. @param depth_in_border 1/m.
  explicit Picture(const std::function<bool(double, double)>& shows, float depth_in_border = 0) {
    const Texture texture(3, 8, 40, 25);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        double sum = 0, weight = 0;
        for (int v = -2; v <= 2; ++v)
          for (int u = -2; u <= 2; ++u) {
            const double w = std::exp(-(u * u + v * v) / (2 * 0.8 * 0.8));
            sum += shows(x + u, y + v) ? w * texture(x + u, y + v) : w * (std::abs(x * 7 + y * 3) % 3), weight += w;
          }
        grey(x, y) = static_cast<std::uint8_t>(std::clamp(sum / weight, 0.0, 255.0));
        inverse_depth(x, y) = shows(x, y) ? 0.1f : depth_in_border;
      }
  }

  /// Largest difference of pixels beside each other, where points of the picture see them: no point is at the very end
  /// of an image.
  int steepest() const {
    int steepest = 0;
    for (int y = kEnd; y < kHeight - kEnd; ++y)
      for (int x = kEnd; x < kWidth - kEnd; ++x)
        if (is_near_picture(x, y))
          steepest = std::max({steepest, std::abs(grey(x + 1, y) - grey(x, y)), std::abs(grey(x, y + 1) - grey(x, y))});
    return steepest;
  }
  bool is_near_picture(int x, int y) const {
    constexpr int kNear = 8;
    for (int v = std::max(0, y - kNear); v <= std::min(kHeight - 1, y + kNear); ++v)
      for (int u = std::max(0, x - kNear); u <= std::min(kWidth - 1, x + kNear); ++u)
        if (inverse_depth(u, v) > 0) return true;
    return false;
  }
  bool is(const Image<std::uint8_t>& other) const {
    return std::equal(grey.row(0), grey.row(0) + kWidth * kHeight, other.row(0));
  }
};

/// Whether a pixel is in a rectangle of this size about the middle of the image, turned.
std::function<bool(double, double)> rectangle(double width, double height, double degrees) {
  return [=](double x, double y) {
    const double a = degrees * M_PI / 180, u = x - kWidth / 2 + 0.5, v = y - kHeight / 2 + 0.5;
    return std::abs(std::cos(a) * u + std::sin(a) * v) <= width / 2 &&
           std::abs(std::cos(a) * v - std::sin(a) * u) <= height / 2;
  };
}

TEST(BlackBorder, IsFilledAsThePictureGoesOn) {
  const Picture whole([](double, double) { return true; });
  ASSERT_LT(whole.steepest(), 30);
  const std::function<bool(double, double)> pictures[] = {
      rectangle(200, 80, 0),                                                            // bars above and below
      rectangle(100, 200, 0),                                                           // at the sides
      rectangle(100, 80, 0),                                                            // all about it
      rectangle(140, 104, 0),                                                           // narrow
      rectangle(160, 120, 10),                                                          // turned
      rectangle(160, 120, 45),                                                          // so that the corners are cut
      rectangle(120, 90, -30),                                                          // with nothing cut
      [](double x, double y) { return std::hypot(x - 80, y - 60) < 58; },               // a fisheye's circle
      [](double x, double y) { return y > 24 - (x - 80) * (x - 80) / 300 && x >= 0; },  // undistorted: an arc
  };
  for (const auto& shows : pictures) {
    Picture picture(shows);
    ASSERT_GT(picture.steepest(), 60);
    const int index = static_cast<int>(&shows - pictures);
    EXPECT_TRUE(BlackBorder().fill(picture.grey, picture.inverse_depth, false)) << index;
    EXPECT_LT(picture.steepest(), 50) << index;
  }
}

TEST(BlackBorder, LeavesThePictureInside) {
  const auto shows = rectangle(100, 80, 0);
  Picture picture(shows);
  const Image<std::uint8_t> before = picture.grey;
  BlackBorder().fill(picture.grey, picture.inverse_depth, false);
  for (int y = 30; y < kHeight - 30; ++y)
    for (int x = 40; x < kWidth - 40; ++x) ASSERT_EQ(picture.grey(x, y), before(x, y)) << x << ' ' << y;
}

TEST(BlackBorder, IsNothingElseThatIsBlack) {
  const auto ragged = [](double x, double y) {  // a shadow at the side
    return x > 20 + 8 * std::sin(1.3 * y) + 6 * std::sin(0.4 * y);
  };
  const auto inside = [](double x, double y) { return std::hypot(x - 80, y - 60) > 30; };
  const auto steep = [](double x, double y) { return x < 60 || x > 70 || y < 20; };  // a pole that leaves the image
  for (const auto& shows : {std::function<bool(double, double)>(ragged), {inside}, {steep}}) {
    Picture picture(shows);
    const Image<std::uint8_t> before = picture.grey;
    EXPECT_FALSE(BlackBorder().fill(picture.grey, picture.inverse_depth, false));
    EXPECT_TRUE(picture.is(before));
  }
}

// A shadow with a straight edge, that moves with the scene.
TEST(BlackBorder, Stays) {
  BlackBorder border;
  const auto is_filled = [&](double left, bool follows) {
    Picture picture([=](double x, double) { return x > left; });
    return border.fill(picture.grey, picture.inverse_depth, follows);
  };
  EXPECT_TRUE(is_filled(20, false)) << "nothing speaks against it yet";
  for (int i = 1; i < 8; ++i) EXPECT_FALSE(is_filled(20 + 4 * i, true)) << i;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(is_filled(30, true)) << i;
  EXPECT_TRUE(is_filled(31, true));
  EXPECT_TRUE(is_filled(30, true));
  for (int i = 1; i < 30; ++i) {  // slowly, as at 30 Hz
    const bool filled = is_filled(30 + i, true);
    EXPECT_FALSE(i >= 4 && filled) << i;
  }
  EXPECT_FALSE(is_filled(50, true));
  EXPECT_TRUE(is_filled(50, false)) << "another recording";
}

// At night the picture beside the border is dark, and may have no depth.
TEST(BlackBorder, EndsAtADarkPicture) {
  constexpr int kBorder = 10;
  Image<std::uint8_t> grey(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      grey(x, y) = static_cast<std::uint8_t>(x < kBorder ? 0 : 10 + (x * x * 7 + y * y * 3 + x * y) % 5);
  const Image<std::uint8_t> before = grey;
  const Image<float> no_depth(kWidth, kHeight);
  EXPECT_TRUE(BlackBorder().fill(grey, no_depth, false));
  for (int y = 0; y < kHeight; ++y)
    for (int x = kBorder + 10; x < kWidth; ++x) ASSERT_EQ(grey(x, y), before(x, y)) << x << ' ' << y;
}

TEST(BlackBorder, HasNoDepth) {
  Picture picture(rectangle(100, 80, 0), 0.2f);
  EXPECT_FALSE(BlackBorder().fill(picture.grey, picture.inverse_depth, false));
}

TEST(BlackBorder, IsAboutAPicture) {
  Picture black([](double, double) { return false; });
  EXPECT_FALSE(BlackBorder().fill(black.grey, black.inverse_depth, false));
  Image<std::uint8_t> tiny(5, 4);
  const Image<float> no_depth(5, 4);
  EXPECT_FALSE(BlackBorder().fill(tiny, no_depth, false));
}

}  // namespace
