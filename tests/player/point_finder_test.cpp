// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/point_finder.hpp"

#include <gtest/gtest.h>

#include "wall.hpp"

namespace player {
namespace {

TEST(PointFinder, WhereTextureAndDepthAre) {
  HandMadeResult hand_made(frame_size);
  const cv::Rect car(30, 20, 40, 30);
  add_measured(hand_made, 4, dot::State::Moving, car);
  runner::SequenceFrame frame = wall(0);
  frame.image.colRange(0, 25).setTo(cv::Scalar::all(90));  // no texture
  frame.depth.rowRange(60, 80).setTo(0);                   // no depth
  PointFinder finder(camera, {});
  const auto points = finder.find(frame, hand_made.result());
  ASSERT_EQ(points.count(4), 1U);
  ASSERT_EQ(points.count(0), 1U);
  EXPECT_GT(points.at(4).size(), 100U);
  for (const cv::Point& point : points.at(4)) EXPECT_TRUE(car.contains(point));
  EXPECT_GT(points.at(0).size(), 100U);
  for (const cv::Point& point : points.at(0)) {
    EXPECT_FALSE(car.contains(point));
    EXPECT_GE(point.x, 25 - 2);  // as far as the gradient's filter reaches
    EXPECT_LT(point.y, 60);
  }
}

TEST(PointFinder, NoneOfObjectsThatAreNotVisible) {
  HandMadeResult hand_made(frame_size);
  hand_made.add(4, dot::State::Moving, cv::Rect());
  PointFinder finder(camera, {});
  EXPECT_EQ(finder.find(wall(0), hand_made.result()).count(4), 0U);
}

}  // namespace
}  // namespace player
