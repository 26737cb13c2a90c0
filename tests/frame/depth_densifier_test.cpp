// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/depth_densifier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/random.hpp"

namespace {

using dot::DepthDensifier;
using dot::Image;

constexpr int kWidth = 160, kHeight = 120;
using Surface = std::function<float(int, int)>;

float road(int x, int y) { return 0.02f + 2e-3f * static_cast<float>(y) + 1e-4f * static_cast<float>(x); }
constexpr float kNear = 0.25f, kFar = 0.05f;
bool in_box(int x, int y) { return x >= 50 && x < 110 && y >= 40 && y < 90; }
float box_before_wall(int x, int y) { return in_box(x, y) ? kNear : kFar; }

/// Every so manieth pixel, at random.
Image<float> scattered(const Surface& surface, double share, unsigned seed = 1) {
  dot::test::Random random(seed);
  Image<float> q(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) q(x, y) = random.uniform() < share ? surface(x, y) : 0;
  return q;
}

/// Beams `rows` apart, a measurement every `columns` along them.
Image<float> scanned(const Surface& surface, int rows, int columns, int first_row = 1) {
  Image<float> q(kWidth, kHeight);
  q.fill(0);
  for (int y = first_row; y < kHeight; y += rows)
    for (int x = 0; x < kWidth; x += columns) q(x, y) = surface(x, y);
  return q;
}

/// @param relative_sigma of a measurement, share of its inverse depth.
Image<float> densified(const Image<float>& sparse, double relative_sigma = 0.01) {
  DepthDensifier densify;
  dot::DepthMeasurements measured;
  Image<float> dense;
  densify(
      sparse, DepthDensifier::density(sparse), [=](double q) { return relative_sigma * q; }, measured, dense);
  return dense;
}

double filled_share(const Image<float>& q) {
  int n = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) n += q(x, y) > 0;
  return static_cast<double>(n) / (kWidth * kHeight);
}

/// Beams of a lidar that is turned against the camera.
Image<float> scanned_aslant(const Surface& surface, int rows, int columns) {
  Image<float> q(kWidth, kHeight);
  q.fill(0);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; x += columns)
      if ((y + x / 3) % rows == 1) q(x, y) = surface(x, y);
  return q;
}

TEST(DepthDensifier, FillsAPlane) {
  for (const Image<float>& sparse :
       {scattered(road, 0.04), scattered(road, 0.1), scanned(road, 6, 3), scanned(road, 20, 3)}) {
    const Image<float> dense = densified(sparse);
    EXPECT_GT(filled_share(dense), 0.8);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        if (dense(x, y) > 0) {
          // The prior of the slopes takes a little of them where measurements are close together.
          ASSERT_NEAR(dense(x, y), road(x, y), 0.02f * road(x, y)) << x << ' ' << y;
        }
  }
}

// Beams far apart are no points far apart, whatever their direction.
TEST(DepthDensifier, FillsBetweenBeamsThatAreAslant) {
  EXPECT_GT(filled_share(densified(scanned_aslant(road, 20, 3))), 0.6);
}

TEST(DepthDensifier, DoesNotBridgeAnEdge) {
  const Image<float> dense = densified(scattered(box_before_wall, 0.06));
  EXPECT_GT(filled_share(dense), 0.6);
  int between = 0, wrong_side = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float q = dense(x, y);
      if (!(q > 0)) continue;
      const bool near = std::abs(q - kNear) < 0.05f * kNear, far = std::abs(q - kFar) < 0.05f * kFar;
      between += !near && !far;
      wrong_side += near != in_box(x, y);
    }
  EXPECT_EQ(between, 0);
  EXPECT_LT(wrong_side, 0.02 * kWidth * kHeight) << "a window just beside the edge sees one side alone";
}

TEST(DepthDensifier, LeavesWhatIsBesideAllMeasurements) {
  Image<float> sparse = scattered(road, 0.05);
  for (int y = 0; y < kHeight; ++y)
    for (int x = kWidth / 2; x < kWidth; ++x) sparse(x, y) = 0;
  const Image<float> dense = densified(sparse);
  for (int y = 0; y < kHeight; ++y)
    for (int x = kWidth / 2 + 4; x < kWidth; ++x) ASSERT_EQ(dense(x, y), 0) << x << ' ' << y;
}

// One beam says nothing of the slope across it.
TEST(DepthDensifier, OneBeamTiltsNothing) {
  dot::test::Random random(2);
  const Surface noisy_wall = [&](int, int) { return kNear * static_cast<float>(1 + 0.01 * random.normal()); };
  Image<float> sparse(kWidth, kHeight);
  sparse.fill(0);
  for (int x = 0; x < kWidth; ++x) sparse(x, 60) = noisy_wall(x, 60);
  const Image<float> dense = densified(sparse);
  EXPECT_GT(filled_share(dense), 0.02);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (dense(x, y) != 0) {
        ASSERT_NEAR(dense(x, y), kNear, 0.03f * kNear) << x << ' ' << y;
      }
}

TEST(DepthDensifier, AllowsForTheNoiseOfItsDepth) {
  dot::test::Random random(3);
  const Surface noisy = [&](int x, int y) { return road(x, y) * static_cast<float>(1 + 0.04 * random.normal()); };
  const Image<float> sparse = scattered(noisy, 0.08);
  EXPECT_GT(filled_share(densified(sparse, 0.04)), 0.8);
  EXPECT_LT(filled_share(densified(sparse, 0.005)), 0.2) << "such a surface is no plane to exact depth";
}

TEST(DepthDensifier, AMeasurementAloneIsTheDepthAboutIt) {
  Image<float> sparse(kWidth, kHeight);
  sparse.fill(0);
  sparse(30, 30) = 0.5f;
  const Image<float> dense = densified(sparse);
  EXPECT_EQ(dense(30, 30), 0.5f);
  EXPECT_EQ(dense(27, 33), 0.5f);
  EXPECT_NEAR(filled_share(dense), 49.0 / (kWidth * kHeight), 1e-9);
}

// Points of a SLAM host before a box, and none on it: planes from one side to the other would hide it.
TEST(DepthDensifier, FillsNothingBetweenMeasurementsFarApart) {
  Image<float> sparse(kWidth, kHeight);
  sparse.fill(0);
  for (int y = 5; y < kHeight; y += 12)
    for (int x = 5; x < kWidth; x += 12) sparse(x, y) = in_box(x, y) ? 0 : kFar;
  const Image<float> dense = densified(sparse);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 54 && x < 106 && y >= 44 && y < 86;
      ASSERT_FALSE(inside && dense(x, y) > 0) << x << ' ' << y;
    }
  EXPECT_NEAR(filled_share(dense), 49.0 / 144, 0.1);
}

// 320 depths in a row of an image of 1920 pixels: as close together, in angle, as 100 in one of 600.
TEST(DepthDensifier, FillsAPlaneInAFineImage) {
  Image<float> sparse(1920, 120);
  sparse.fill(0);
  for (int y = 2; y < sparse.height(); y += 6)
    for (int x = 2; x < sparse.width(); x += 6) sparse(x, y) = road(x, y);
  const Image<float> dense = densified(sparse);
  for (int y = 20; y < sparse.height() - 20; ++y)
    for (int x = 20; x < sparse.width() - 20; ++x) ASSERT_NEAR(dense(x, y), road(x, y), 1e-4) << x << ' ' << y;
}

TEST(DepthDensifier, TheNearerOfTwoMeasurementsCounts) {
  Image<float> sparse(kWidth, kHeight);
  sparse.fill(0);
  for (int y = 5; y < kHeight; y += 12)
    for (int x = 5; x < kWidth; x += 12) sparse(x, y) = kFar;
  sparse(30, 30) = kNear;
  sparse(34, 30) = kFar;
  const Image<float> dense = densified(sparse);
  EXPECT_EQ(dense(31, 31), kNear);
  EXPECT_EQ(dense(33, 29), kFar);
  EXPECT_EQ(dense(34, 30), kFar);
}

TEST(Density, IsOfWhatIsAboutTheMeasurements) {
  EXPECT_EQ(DepthDensifier::density(scattered(road, 0)), 0);
  EXPECT_NEAR(DepthDensifier::density(scattered(road, 0.05)), 0.06, 0.01);
  EXPECT_NEAR(DepthDensifier::density(scattered(road, 0.5)), 0.5, 0.02);
  Image<float> part = scattered(road, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (x > 40 || y > 40) part(x, y) = 0;
  EXPECT_GT(DepthDensifier::density(part), 3 * DepthDensifier::kSparse)
      << "dense in a corner of the image is not sparse";
}

// Whichever rows the beams fall on: what looks at every fourth row may miss them all.
TEST(Density, IsTheSameForAnyPhaseOfTheBeams) {
  for (const int rows : {2, 4, 6, 8, 12})
    for (int first = 0; first < rows; ++first) {
      const double share = 1.0 / (rows * 3), density = DepthDensifier::density(scanned(road, rows, 3, first));
      EXPECT_GT(density, 0.8 * share) << rows << ' ' << first;
      // The box of 25 pixels about a beam has 3 beams that are 12 apart, not 25 / 12; cut at the border, a few more.
      EXPECT_LT(density, 1.1 * 3 * 12 / 25 * share) << rows << ' ' << first;
    }
}

}  // namespace
