// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/moved_outlines.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "wall.hpp"

namespace player {
namespace {

const cv::Rect before(40, 30, 20, 16);

/// The outline that is predicted after a frame in which object 4 covered `before`.
Outlines predicted(const dot::Result& now, const runner::SequenceFrame& first = wall(0)) {
  HandMadeResult hand_made(frame_size);
  add_measured(hand_made, 4, dot::State::Moving, before);
  MovedOutlines moved(camera);
  EXPECT_TRUE(moved.next(first, hand_made.result()).empty()) << "nothing came before";
  const auto outlines = moved.next(wall(1), now);
  return outlines.count(4) > 0 ? outlines.at(4) : Outlines{};
}

void expect_near(const cv::Rect& a, const cv::Rect& b) {
  EXPECT_NEAR(a.x, b.x, 1);
  EXPECT_NEAR(a.y, b.y, 1);
  EXPECT_NEAR(a.br().x, b.br().x, 1);
  EXPECT_NEAR(a.br().y, b.br().y, 1);
}

TEST(MovedOutlines, FollowCameraAndObject) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 4, dot::State::Moving, before);
  object.T_o[3] = 1;  // metres to the right: 10 px at 10 m
  dot::Result result = tracked(hand_made);
  result.camera.T_cur_prev[7] = -0.5;  // 5 px up
  const Outlines outlines = predicted(result);
  ASSERT_EQ(outlines.size(), 1U);
  expect_near(cv::boundingRect(outlines[0]), before + cv::Point(10, -5));
}

TEST(MovedOutlines, GrowAsTheObjectComesNear) {
  HandMadeResult hand_made(frame_size);
  add_measured(hand_made, 4, dot::State::Moving, before).T_o[11] = -5;  // to half the distance
  const Outlines outlines = predicted(tracked(hand_made));
  ASSERT_EQ(outlines.size(), 1U) << "no gaps";
  expect_near(cv::boundingRect(outlines[0]), cv::Rect(20, 20, 40, 33));
}

TEST(MovedOutlines, WithoutAMeasurementByTheFusedVelocityOfAMover) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 4, dot::State::Moving, before);
  object.reason = dot::Reason::Occluded;
  object.fused_velocity = {10, 0, 0};  // m/s, 1 m in the interval
  EXPECT_EQ(predicted(tracked(hand_made)).size(), 1U);
  expect_near(cv::boundingRect(predicted(tracked(hand_made)).at(0)), before + cv::Point(10, 0));
  object.last_decided = dot::State::Static;
  expect_near(cv::boundingRect(predicted(tracked(hand_made)).at(0)), before);
}

TEST(MovedOutlines, PixelsWithoutDepthGoWithTheOthers) {
  HandMadeResult hand_made(frame_size);
  add_measured(hand_made, 4, dot::State::Moving, before).T_o[3] = 1;
  runner::SequenceFrame holes = wall(0);
  holes.depth(cv::Rect(40, 30, 12, 16)).setTo(0);
  expect_near(cv::boundingRect(predicted(tracked(hand_made), holes).at(0)), before + cv::Point(10, 0));
  holes.depth.setTo(0);
  EXPECT_TRUE(predicted(tracked(hand_made), holes).empty()) << "no depth at all";
}

TEST(MovedOutlines, NoneOfWhatWasHiddenInTheFrameBefore) {
  HandMadeResult seen(frame_size), hidden(frame_size);
  add_measured(seen, 4, dot::State::Moving, before);
  hidden.add(4, dot::State::Moving, cv::Rect());
  MovedOutlines moved(camera);
  moved.next(wall(0), seen.result());
  moved.next(wall(1), tracked(hidden));
  EXPECT_EQ(moved.next(wall(2), tracked(seen)).count(4), 0U);
  EXPECT_EQ(moved.next(wall(3), tracked(seen)).count(4), 1U);
}

TEST(MovedOutlines, NoneAfterAGuessedMotionOrOutOfSight) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 4, dot::State::Moving, before);
  dot::Result lost = tracked(hand_made);
  lost.camera.status = dot::CameraStatus::Lost;
  EXPECT_TRUE(predicted(lost).empty());
  object.T_o[3] = 50;
  EXPECT_TRUE(predicted(tracked(hand_made)).empty());
  object.T_o[3] = 0;
  object.T_o[11] = -20;  // behind the camera
  EXPECT_TRUE(predicted(tracked(hand_made)).empty());
  EXPECT_TRUE(predicted(tracked(HandMadeResult(frame_size))).empty()) << "the object ended";
}

}  // namespace
}  // namespace player
