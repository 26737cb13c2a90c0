// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/template.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dot/camera/pinhole.hpp"
#include "dot/mask/warp.hpp"

namespace {

using dot::Image;
using dot::Mask;
using dot::MaskTemplate;

constexpr int kWidth = 120, kHeight = 80;
constexpr double kTolerance = 0.3;

bool in_object(int u, int v) {
  const double x = (u - 60) / 35.0, y = (v - 40) / 25.0;
  return x * x + y * y < 1;
}

/// A slanted surface, 5 to 10 m away.
float surface(int u, int v) {
  return 0.15f + 0.001f * static_cast<float>(u - 60) + 0.0005f * static_cast<float>(v - 40);
}

Mask object_mask() {
  Mask mask;
  dot::fill_mask({0, 0, kWidth, kHeight}, in_object, mask);
  return mask;
}

/// The object before a wall at 50 m.
Image<float> scene() {
  Image<float> q(kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) q(u, v) = in_object(u, v) ? surface(u, v) : 0.02f;
  return q;
}

/// Largest relative error of a template against the surface, over its mask; checks that the rest is 0.
double worst_error(const MaskTemplate& found) {
  double worst = 0;
  EXPECT_EQ(found.inverse_depth.width(), found.mask.width());
  EXPECT_EQ(found.inverse_depth.height(), found.mask.height());
  for (int v = 0; v < found.mask.height(); ++v) {
    for (int u = 0; u < found.mask.width(); ++u) {
      const float q = found.inverse_depth(u, v);
      if (found.mask.pixels(u, v) == 0) {
        EXPECT_EQ(q, 0);
        continue;
      }
      EXPECT_GT(q, 0);
      const double truth = surface(found.mask.x + u, found.mask.y + v);
      worst = std::max(worst, std::abs(q - truth) / truth);
    }
  }
  return worst;
}

TEST(Template, TakesTheSurface) {
  MaskTemplate found;
  ASSERT_TRUE(dot::make_template(object_mask(), scene().view(), kTolerance, found));
  EXPECT_EQ(found.mask.box(), object_mask().box());
  EXPECT_EQ(found.mask.area, object_mask().area);
  EXPECT_LT(worst_error(found), 0.03);
  EXPECT_NEAR(found.median, 0.15, 0.002);
}

TEST(Template, SmoothsNoise) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 0.05f);
  Image<float> q = scene();
  double before = 0, after = 0;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) q(u, v) *= 1 + noise(random);
  MaskTemplate found;
  ASSERT_TRUE(dot::make_template(object_mask(), q.view(), kTolerance, found));
  for (int v = 30; v < 50; ++v) {
    for (int u = 40; u < 80; ++u) {
      before += std::pow(q(u, v) / surface(u, v) - 1, 2);
      after += std::pow(found.inverse_depth(u - found.mask.x, v - found.mask.y) / surface(u, v) - 1, 2);
    }
  }
  EXPECT_LT(after, before / 15) << "25 values are averaged";
}

TEST(Template, FillsMissingDepth) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> which(0, 3);
  const float invalid[] = {0, -0.1f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  Image<float> q = scene();
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      if (random() % 10 < 3 || std::hypot(u - 55, v - 35) < 8) q(u, v) = invalid[which(random)];
  MaskTemplate found;
  ASSERT_TRUE(dot::make_template(object_mask(), q.view(), kTolerance, found));
  EXPECT_LT(worst_error(found), 0.05) << "30 % missing and a hole of 16 pixels";
}

TEST(Template, SpreadsSparseDepth) {
  Image<float> q(kWidth, kHeight);
  q.fill(0);
  for (int v = 0; v < kHeight; v += 7)
    for (int u = 0; u < kWidth; u += 5)
      if (in_object(u, v)) q(u, v) = surface(u, v);
  MaskTemplate found;
  ASSERT_TRUE(dot::make_template(object_mask(), q.view(), kTolerance, found));
  EXPECT_LT(worst_error(found), 0.1);
}

/// The object's mask with a leak: `columns` more of what is beside it.
Mask leaking_mask(int columns) {
  Mask mask;
  dot::fill_mask(
      {0, 0, kWidth, kHeight},
      [&](int u, int v) { return in_object(u, v) || (u >= 90 && u < 90 + columns && v > 20 && v < 60); }, mask);
  return mask;
}

TEST(Template, IgnoresWhatLeaksIn) {
  for (const float other : {0.02f, 0.9f}) {  // a wall behind, a post in front
    for (const int columns : {6, 15, 28}) {
      Image<float> q = scene();
      for (int v = 0; v < kHeight; ++v)
        for (int u = 0; u < kWidth; ++u)
          if (!in_object(u, v)) q(u, v) = other;
      const Mask mask = leaking_mask(columns);
      const double share = 1 - static_cast<double>(object_mask().area) / mask.area;
      MaskTemplate found;
      ASSERT_TRUE(dot::make_template(mask, q.view(), kTolerance, found));
      EXPECT_EQ(found.mask.area, mask.area);
      EXPECT_NEAR(found.median, 0.15, 0.015) << other << ' ' << share;
      for (int v = 0; v < mask.height(); ++v) {
        for (int u = 0; u < mask.width(); ++u) {
          if (mask.pixels(u, v) == 0) continue;
          const float value = found.inverse_depth(u, v);
          ASSERT_GT(value, 0.09f) << "leak of " << share;
          ASSERT_LT(value, 0.21f) << "leak of " << share;
        }
      }
    }
  }
}

TEST(Template, NeedsSomeDepth) {
  const Mask mask = object_mask();
  Image<float> q(kWidth, kHeight);
  q.fill(0);
  MaskTemplate found;
  EXPECT_FALSE(dot::make_template(mask, q.view(), kTolerance, found));
  for (int i = 0; i < dot::kMinTemplateDepth - 1; ++i) q(50 + i, 40) = 0.1f;
  EXPECT_FALSE(dot::make_template(mask, q.view(), kTolerance, found));
  EXPECT_TRUE(found.mask.empty());
  EXPECT_TRUE(found.inverse_depth.empty());
  q(50, 41) = 0.1f;
  EXPECT_TRUE(dot::make_template(mask, q.view(), kTolerance, found));
  EXPECT_NEAR(found.inverse_depth(0, mask.height() / 2), 0.1f, 1e-6f) << "far from any measurement";
  EXPECT_FALSE(dot::make_template(Mask{}, q.view(), kTolerance, found));
  EXPECT_TRUE(found.mask.empty());
}

TEST(Template, MayBeMadeFromItsOwnMaskWithUsedBuffers) {
  dot::TemplateWorkspace workspace;
  MaskTemplate expected, found;
  const Image<float> q = scene();
  ASSERT_TRUE(dot::make_template(object_mask(), q.view(), kTolerance, expected));
  Mask everything;
  dot::fill_mask(
      {0, 0, kWidth, kHeight}, [](int, int) { return true; }, everything);
  ASSERT_TRUE(dot::make_template(everything, q.view(), kTolerance, workspace, found));
  found.mask = object_mask();
  ASSERT_TRUE(dot::make_template(found.mask, q.view(), kTolerance, workspace, found));
  EXPECT_EQ(found.mask.box(), expected.mask.box());
  EXPECT_EQ(found.median, expected.median);
  for (int v = 0; v < expected.mask.height(); ++v)
    for (int u = 0; u < expected.mask.width(); ++u) ASSERT_EQ(found.inverse_depth(u, v), expected.inverse_depth(u, v));
}

/// What make_template promises, by looking at every pixel for every pixel.
double check_by_brute_force(const Mask& mask, const Image<float>& q, const MaskTemplate& found) {
  const auto measured = [&](int u, int v) {
    const bool seen = mask.at(u, v) && q.contains(u, v) && std::isfinite(q(u, v)) && q(u, v) > 0;
    return seen ? static_cast<double>(q(u, v)) : 0.0;
  };
  std::vector<double> values;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      if (measured(u, v) > 0) values.push_back(measured(u, v));
  const auto percentile = [](std::vector<double>& all, double share) {
    std::sort(all.begin(), all.end());
    return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  };
  const double median = percentile(values, 0.5);
  const double low = std::max(percentile(values, 0.2), (1 - kTolerance) * median) * (1 - kTolerance);
  const double high = std::min(percentile(values, 0.8), (1 + kTolerance) * median) * (1 + kTolerance);
  std::vector<double> accepted;
  for (const double value : values)
    if (value >= low && value <= high) accepted.push_back(value);
  EXPECT_EQ(found.median, percentile(accepted, 0.5));
  for (int v = 0; v < mask.height(); ++v)
    for (int u = 0; u < mask.width(); ++u) {
      double sum = 0;
      int count = 0;
      for (int radius = 2; mask.pixels(u, v) && count < 5; radius *= 2) {
        sum = count = 0;
        for (int j = v - radius; j <= v + radius; ++j)
          for (int i = u - radius; i <= u + radius; ++i) {
            const double value = measured(mask.x + i, mask.y + j);
            if (value < low || value > high) continue;
            sum += value;
            ++count;
          }
      }
      EXPECT_NEAR(found.inverse_depth(u, v), count > 0 ? sum / count : 0, 1e-6);
    }
  return static_cast<double>(accepted.size()) / static_cast<double>(values.size());
}

TEST(Template, EqualsBruteForce) {
  const float none[] = {0, -1, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  std::mt19937 random(5);
  dot::TemplateWorkspace workspace;
  MaskTemplate found;
  double accepted = 0;
  constexpr int rounds = 12;
  for (int round = 0; round < rounds; ++round) {
    Image<float> q(kWidth, kHeight);
    for (int v = 0; v < kHeight; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const float spread = random() % 3 ? 0.1f : 0.7f;  // of the object, and of what is before and behind it
        q(u, v) = 0.1f * (1 + spread * (static_cast<float>(random() % 2001) / 1000 - 1));
        if (static_cast<int>(random() % 20) < 2 * round - 3) q(u, v) = none[random() % 4];
      }
    Mask mask;
    const int x = static_cast<int>(random() % 60) - 10, y = static_cast<int>(random() % 40) - 10;
    dot::fill_mask(
        {x, y, 40, 30}, [](int u, int v) { return (u * u + 3 * v) % 11 != 0; }, mask);
    ASSERT_TRUE(dot::make_template(mask, q.view(), kTolerance, workspace, found));
    accepted += check_by_brute_force(mask, q, found) / rounds;
  }
  EXPECT_GT(accepted, 0.5);
  EXPECT_LT(accepted, 0.9);
}

}  // namespace
