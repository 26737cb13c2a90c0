// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/repeated_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/random.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::Image;
using dot::Pyramid;
using dot::RepeatedImage;
using dot::test::Texture;

constexpr int kWidth = 320, kHeight = 240;

/// A wall that moves to the left before a camera, with a box in front of it that moves by itself.
struct Exposure {
  double wall = 0;   ///< pixels by which the wall has moved
  double box = 0;    ///< pixels by which the box has moved
  double noise = 2;  ///< grey values
  double gain = 1;   ///< of the exposure
};

class Camera {
 public:
  Pyramid take(const Exposure& e) {
    Image<std::uint8_t> grey(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const bool on_box = x >= 120 && x < 200 && y >= 90 && y < 150;
        const double clean = on_box ? box_(x + e.box, y) : wall_(x + e.wall, y);
        grey(x, y) = static_cast<std::uint8_t>(std::clamp(e.gain * clean + random_.normal(e.noise), 0.0, 255.0));
      }
    Pyramid out;
    out.build(std::as_const(grey).view(), 3);
    return out;
  }

 private:
  Texture wall_{1, 12, 100}, box_{2, 12, 100};
  dot::test::Random random_{5};
};

/// Whether each exposure repeats the one before.
std::vector<bool> repeats(const std::vector<Exposure>& exposures) {
  Camera camera;
  RepeatedImage repeated;
  Pyramid before;
  std::vector<bool> out;
  for (const Exposure& each : exposures) {
    const Pyramid now = camera.take(each);
    out.push_back(repeated.repeats(now, out.empty() ? nullptr : &before));
    before = now;
  }
  return out;
}

using Answers = std::vector<bool>;

TEST(RepeatedImage, IsKnownThoughItHasOtherNoise) {
  for (const double noise : {0.0, 1.0, 3.0, 5.0})
    EXPECT_EQ(repeats({{0, 0, noise}, {4, 4, noise}, {4, 4, noise}, {8, 8, noise}, {8, 8, noise}, {8, 8, noise}}),
              (Answers{false, false, true, false, true, true}))
        << noise;
}

TEST(RepeatedImage, IsKnownByWhatMovesBeforeACameraThatStands) {
  EXPECT_EQ(repeats({{0, 0}, {0, 3}, {0, 3}, {0, 6}, {0, 9}, {0, 9}}),
            (Answers{false, false, true, false, false, true}));
}

TEST(RepeatedImage, IsNoneOfACameraThatStandsBeforeASceneAtRest) {
  EXPECT_EQ(repeats({{}, {}, {}, {}, {}}), Answers(5, false));
}

TEST(RepeatedImage, IsNoneWhereSomethingStillMoves) {
  EXPECT_EQ(repeats({{0, 0}, {4, 4}, {4, 8}, {4, 12}}), Answers(4, false)) << "the camera stops, the box does not";
}

TEST(RepeatedImage, IsNoneAfterAChangeOfTheLightAlone) {
  EXPECT_EQ(repeats({{}, {0, 0, 2, 0.9}, {0, 0, 2, 0.9}, {0, 0, 2, 0.9}, {0, 0, 2, 1}, {}}), Answers(6, false));
}

// A hand that shakes stands still for a moment, but never exactly.
TEST(RepeatedImage, IsNoneAtATurningPoint) {
  EXPECT_EQ(repeats({{0, 0}, {5, 5}, {5.4, 5.4}, {0, 0}, {-0.3, -0.3}, {5, 5}}), Answers(6, false));
}

TEST(RepeatedImage, OfTheSameBytesIsKnownWithoutTexture) {
  RepeatedImage repeated;
  Image<std::uint8_t> plain(kWidth, kHeight);
  plain.fill(90);
  Pyramid a;
  a.build(std::as_const(plain).view(), 3);
  EXPECT_FALSE(repeated.repeats(a, nullptr));
  EXPECT_TRUE(repeated.repeats(a, &a));
  plain(5, 5) = 200;
  Pyramid b;
  b.build(std::as_const(plain).view(), 3);
  EXPECT_FALSE(repeated.repeats(b, &a)) << "nothing tells";
}

TEST(RepeatedImage, IsNotKnownAfterAGapOrABlackImage) {
  Camera camera;
  RepeatedImage repeated;
  Pyramid first = camera.take({0, 0});
  const Pyramid second = camera.take({4, 4}), again = camera.take({4, 4});
  Image<std::uint8_t> dark(kWidth, kHeight);
  dark.fill(0);
  Pyramid black;
  black.build(std::as_const(dark).view(), 3);
  EXPECT_FALSE(repeated.repeats(first, nullptr));
  EXPECT_FALSE(repeated.repeats(second, &first));
  EXPECT_FALSE(repeated.repeats(again, nullptr));
  EXPECT_FALSE(repeated.repeats(second, &again)) << "what is usual is not known yet";
  EXPECT_FALSE(repeated.repeats(black, &second));
  EXPECT_FALSE(repeated.repeats(first, &black));
  EXPECT_FALSE(repeated.repeats(first = camera.take({0, 0}), &black)) << "what was usual before is not known any more";
}

TEST(RepeatedImage, OfAnotherSizeIsNone) {
  Camera camera;
  RepeatedImage repeated;
  const Pyramid first = camera.take({});
  EXPECT_FALSE(repeated.repeats(first, nullptr));
  for (const auto& [width, levels] : {std::pair{40, 1}, {300, 3}}) {
    Image<std::uint8_t> small(width, 21);
    small.fill(7);
    Pyramid other;
    other.build(std::as_const(small).view(), levels);
    EXPECT_FALSE(repeated.repeats(other, &first));
    EXPECT_TRUE(repeated.repeats(other, &other));
  }
}

}  // namespace
