// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/depth_measurements.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using dot::Image;

TEST(DepthMeasurements, AreListedRowByRow) {
  Image<float> sparse(8, 4);
  sparse.fill(0);
  sparse(5, 1) = 0.5f;
  sparse(2, 1) = 0.25f;
  sparse(7, 3) = 1;
  dot::DepthMeasurements measured;
  EXPECT_FALSE(measured.far_apart());
  measured.list(sparse);
  EXPECT_TRUE(measured.far_apart());
  ASSERT_EQ(measured.all.size(), 3U);
  EXPECT_EQ(measured.all[0].x, 2);
  EXPECT_EQ(measured.all[1].x, 5);
  EXPECT_EQ(measured.all[2].y, 3);
  EXPECT_EQ(measured.begin, (std::vector<std::size_t>{0, 0, 2, 2, 3}));
  measured.clear();
  EXPECT_FALSE(measured.far_apart());
}

TEST(DepthMeasurements, AreCountedInAMask) {
  Image<float> sparse(8, 4);
  sparse.fill(0);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 4; ++y) sparse(x, y) = static_cast<float>(10 * y + x + 1);
  dot::DepthMeasurements measured;
  measured.list(sparse);
  Image<std::uint8_t> mask(3, 3);
  mask.fill(255);
  mask(1, 0) = 0;
  const Image<std::uint8_t>& shape = mask;
  EXPECT_EQ(measured.inside(6, 2, shape.view()), 3) << "the rest is outside of the image, or of the mask";
}

}  // namespace
