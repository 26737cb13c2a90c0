// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/depth_trimmer.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace {

using dot::DepthTrimmer;
using dot::Image;
using dot::Mask;

constexpr int kWidth = 400, kHeight = 300;
constexpr double kFocal = 400;
constexpr float kObject = 0.1f, kWall = 0.02f;  // 1/m

struct Noise {
  double pixel_sigma(double) const { return 2e-4; }
};

Mask rectangle(int x, int y, int width, int height) {
  Mask out;
  dot::fill_mask(
      {x, y, width, height}, [](int, int) { return true; }, out);
  return out;
}

Mask ellipse(double x, double y, double a, double b) {
  Mask out;
  dot::fill_mask(
      {0, 0, kWidth, kHeight}, [=](int u, int v) { return std::hypot((u - x) / a, (v - y) / b) < 1; }, out);
  return out;
}

/// The frame's bounding box of a mask, made wider.
Mask box_of(const Mask& mask, int margin = 0) {
  return rectangle(mask.x - margin, mask.y - margin, mask.width() + 2 * margin, mask.height() + 2 * margin);
}

bool same(const Mask& a, const Mask& b) { return a.area == b.area && dot::overlap(a, b) == a.area; }

/// A wall, before which the tests place objects.
struct Depth {
  Image<float> q;
  Depth() {
    q.resize(kWidth, kHeight);
    q.fill(kWall);
  }
  /// @param at (u, v) -> 1/m of the mask's pixels.
  template <typename At>
  void place(const Mask& mask, At&& at) {
    for (int v = mask.y; v < mask.y + mask.height(); ++v)
      for (int u = mask.x; u < mask.x + mask.width(); ++u)
        if (mask.at(u, v)) q(u, v) = at(u, v);
  }
  void place(const Mask& mask, float value) {
    place(mask, [value](int, int) { return value; });
  }
  void blur_by_noise() {
    dot::test::Random random(3);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) q(u, v) += static_cast<float>(random.normal() * Noise{}.pixel_sigma(0));
  }
};

/// Has seen enough boxes to know that masks are wide.
DepthTrimmer after_boxes() {
  Depth depth;
  const Mask object = ellipse(200, 150, 40, 25);
  depth.place(object, kObject);
  DepthTrimmer out;
  for (int i = 0; i < 10; ++i) {
    Mask box = box_of(object);
    out.trim(depth.q, kFocal, Noise{}, box);
  }
  return out;
}

/// The object's depth as a trimmer found it that knows that masks are wide.
float trim(const Depth& depth, Mask& mask) { return after_boxes().trim(depth.q, kFocal, Noise{}, mask); }

TEST(DepthTrimmer, ABoxBecomesItsObject) {
  const std::array<std::pair<double, double>, 3> sizes{{{12, 9}, {40, 25}, {150, 110}}};
  for (const auto& [a, b] : sizes) {
    Depth depth;
    const Mask object = ellipse(200, 150, a, b);
    depth.place(object, kObject);
    depth.blur_by_noise();
    for (const int margin : {0, 2, static_cast<int>(b / 5)}) {
      Mask mask = box_of(object, margin);
      EXPECT_NEAR(trim(depth, mask), kObject, 1e-3f);
      EXPECT_EQ(dot::overlap(mask, object), object.area) << a << " x " << b << ", margin " << margin;
      EXPECT_LE(mask.area, 1.001 * object.area) << a << " x " << b << ", margin " << margin;  // cells may miss a corner
    }
  }
}

TEST(DepthTrimmer, AMaskThatFitsStaysAsItIs) {
  Depth depth;
  const Mask object = ellipse(200, 150, 60, 40);
  depth.place(object, kObject);
  depth.blur_by_noise();
  Mask mask = object;
  EXPECT_NEAR(trim(depth, mask), kObject, 1e-3f);
  EXPECT_TRUE(same(mask, object));
}

// One wide mask may be an error of the depth; many are a property of what makes the masks.
TEST(DepthTrimmer, NothingIsTakenOutUnlessMasksAreWide) {
  Depth depth;
  const Mask object = ellipse(200, 150, 60, 40), box = box_of(object);
  depth.place(object, kObject);
  DepthTrimmer trimmer;
  const auto show = [&](const Mask& shown) {
    Mask mask = shown;
    trimmer.trim(depth.q, kFocal, Noise{}, mask);
    return mask;
  };
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(same(show(i % 20 == 0 ? box : object), i % 20 == 0 ? box : object)) << i;
  EXPECT_EQ(trimmer.wide_share(), 0);
  int untouched = 0;
  while (same(show(box), box)) ASSERT_LT(++untouched, 50);
  EXPECT_GT(untouched, 2);
  EXPECT_GT(trimmer.wide_share(), 0.03);
  for (int i = 0; i < 300; ++i) show(object);
  EXPECT_EQ(trimmer.wide_share(), 0) << "they fit again";
  for (int i = 0; i < 100; ++i) show(box);
  EXPECT_GT(trimmer.wide_share(), 0.1);
  trimmer.forget();
  EXPECT_EQ(trimmer.wide_share(), 0);
  EXPECT_TRUE(same(show(box), box));
}

TEST(DepthTrimmer, ANearerSurfaceIsTakenOutToo) {
  Depth depth;
  const Mask object = rectangle(100, 100, 120, 80), pole = rectangle(115, 60, 12, 200);
  depth.place(object, kObject);
  depth.place(pole, 0.3f);
  Mask mask = object;
  trim(depth, mask);
  EXPECT_EQ(mask.area, object.area - 12 * 80);
  EXPECT_EQ(dot::overlap(mask, pole), 0);
}

// A lorry beside the camera is much longer than what its middle tells, but no jump separates its ends from it.
TEST(DepthTrimmer, ALongObjectIsKept) {
  Depth depth;
  const Mask lorry = rectangle(20, 80, 360, 60);
  depth.place(lorry, [](int u, int) { return 0.04f + 0.3f * std::pow(static_cast<float>(380 - u) / 360, 3.0f); });
  Mask mask = lorry;
  EXPECT_GT(trim(depth, mask), 0);
  EXPECT_TRUE(same(mask, lorry)) << mask.area << " of " << lorry.area;
}

TEST(DepthTrimmer, AWindowInsideTheObjectIsKept) {
  Depth depth;
  const Mask object = rectangle(100, 100, 120, 80), window = rectangle(105, 110, 60, 20);
  depth.place(object, kObject);
  depth.place(window, kWall);
  Mask mask = object;
  trim(depth, mask);
  EXPECT_TRUE(same(mask, object));
}

TEST(DepthTrimmer, WithoutDepthNothingIsKnown) {
  Depth depth;
  depth.q.fill(0);
  const Mask box = rectangle(100, 100, 120, 80);
  Mask mask = box;
  EXPECT_EQ(trim(depth, mask), 0);
  EXPECT_TRUE(same(mask, box));
  depth.place(rectangle(140, 130, 40, 20), kObject);  // the middle alone is measured
  EXPECT_EQ(trim(depth, mask), kObject);
  EXPECT_TRUE(same(mask, box));
}

TEST(DepthTrimmer, MasksAtTheImagesBorderAndOfFewPixels) {
  Depth depth;
  const Mask corner = rectangle(0, 0, 60, 40), whole = rectangle(0, 0, kWidth, kHeight);
  depth.place(corner, kObject);
  Mask mask = rectangle(0, 0, 68, 46);
  EXPECT_EQ(trim(depth, mask), kObject);
  EXPECT_TRUE(same(mask, corner));
  mask = whole;
  EXPECT_EQ(trim(depth, mask), kWall);
  EXPECT_TRUE(same(mask, whole)) << "what is so large may be as long as it is far";
  const Mask pixel = rectangle(kWidth - 1, kHeight - 1, 1, 1);
  mask = pixel;
  EXPECT_EQ(trim(depth, mask), 0);
  EXPECT_TRUE(same(mask, pixel));
}

TEST(DepthTrimmer, SharedPixelsGoToTheObjectOfTheirDepth) {
  Depth depth;
  const Mask car = ellipse(150, 150, 60, 40), other = ellipse(230, 140, 50, 30);
  depth.place(other, 0.05f);
  depth.place(car, kObject);
  depth.blur_by_noise();
  Mask a = box_of(car), b = box_of(other);
  DepthTrimmer{}.separate(depth.q, Noise{}, kObject, 0.05f, a, b);
  const Mask shared = rectangle(b.x, b.y, car.x + car.width() - b.x, b.height());
  EXPECT_EQ(dot::overlap(a, b), 0);
  for (int v = shared.y; v < shared.y + shared.height(); ++v)
    for (int u = shared.x; u < shared.x + shared.width(); ++u) {
      if (!car.at(u, v) && !other.at(u, v)) continue;
      EXPECT_EQ(a.at(u, v), car.at(u, v)) << u << ", " << v;
      EXPECT_EQ(b.at(u, v), !car.at(u, v)) << u << ", " << v;
    }
}

TEST(DepthTrimmer, TwoMasksOfOneObjectStayAsTheyAre) {
  Depth depth;
  const Mask object = ellipse(200, 150, 60, 40);
  depth.place(object, kObject);
  depth.blur_by_noise();
  const Mask upper = rectangle(140, 110, 120, 50);
  Mask a = object, b = upper;
  DepthTrimmer{}.separate(depth.q, Noise{}, kObject, 1.03f * kObject, a, b);
  EXPECT_TRUE(same(a, object));
  EXPECT_TRUE(same(b, upper));
  DepthTrimmer{}.separate(depth.q, Noise{}, 0, kObject, a, b);  // of one no depth is known
  EXPECT_TRUE(same(a, object));
  EXPECT_TRUE(same(b, upper));
}

TEST(DepthTrimmer, MasksApartAreNotRead) {
  Depth depth;
  Mask a = rectangle(0, 0, 50, 50), b = rectangle(50, 0, 50, 50), c = rectangle(0, 50, 50, 50);
  DepthTrimmer{}.separate(depth.q, Noise{}, kObject, kWall, a, b);
  DepthTrimmer{}.separate(depth.q, Noise{}, kObject, kWall, a, c);
  EXPECT_EQ(a.area, 2500);
  EXPECT_EQ(b.area, 2500);
  EXPECT_EQ(c.area, 2500);
}

}  // namespace
