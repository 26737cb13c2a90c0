// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run/overlay.hpp"
#include "support/hand_made_result.hpp"

namespace {

/// Measured, without errors.
dot::ObjectResult object(double speed, double point_speed) {
  dot::ObjectResult o;
  o.state = dot::State::Moving;
  o.reason = dot::Reason::None;
  o.speed = speed;
  o.point_speed = point_speed;
  return o;
}

TEST(Turning, IsWhatThePointsHaveMoreThanTheCentroid) {
  dot::ObjectResult o = object(3, 5);
  o.velocity_covariance = {1, 0, 0, 0, 2, 0, 0, 0, 1};
  o.point_speed_sigma = 2.5;
  const runner::Turning turning = runner::turning_of(o);
  EXPECT_DOUBLE_EQ(turning.speed, 4);
  EXPECT_DOUBLE_EQ(turning.sigma, 1.5);
  EXPECT_TRUE(turning.exceeds(0.9));
  EXPECT_FALSE(turning.exceeds(1.1));
}

TEST(Turning, IsNoneWhereRoundingLeavesLess) {
  dot::ObjectResult o = object(3, std::nextafter(3, 0));
  o.velocity_covariance = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_EQ(runner::turning_of(o).speed, 0);
  EXPECT_EQ(runner::turning_of(o).sigma, 0);
}

TEST(SpeedLabel, OfWhatTurnsIsThatOfItsPoints) {
  EXPECT_EQ(runner::speed_label(object(8.06, 8.2)), "8.1 m/s");
  EXPECT_EQ(runner::speed_label(object(0, 0.11)), "0.1 m/s");
  EXPECT_EQ(runner::speed_label(object(0, 0.041)), "0.041 m/s");
  EXPECT_EQ(runner::speed_label(object(0.03, 0.03)), "0.030 m/s") << "near things move slowly";
  dot::ObjectResult doubtful = object(0.5, 1.2);
  doubtful.point_speed_sigma = 1;
  EXPECT_EQ(runner::speed_label(doubtful), "0.5 m/s");
}

TEST(SpeedLabel, StandsInTheOverlay) {
  const auto overlay = [](double point_speed) {
    HandMadeResult hand_made({200, 100});
    dot::ObjectResult& o = hand_made.add(4, dot::State::Moving, cv::Rect(60, 40, 60, 40));
    o.area = 2400;
    o.box = {60, 40, 60, 40};
    o.reason = dot::Reason::None;
    o.point_speed = point_speed;
    runner::SequenceFrame frame;
    frame.image = cv::Mat(100, 200, CV_8UC3, cv::Scalar::all(90));
    return runner::draw_overlay(frame, hand_made.result(), 1);
  };
  EXPECT_GT(cv::norm(overlay(0.7), overlay(0.3), cv::NORM_INF), 0);
}

}  // namespace
