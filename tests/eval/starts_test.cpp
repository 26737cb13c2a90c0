// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/starts.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_result.hpp"

namespace eval {
namespace {

using dot::State;

const cv::Size frame_size(120, 60);

/// Object i stands in a column of 30 x 40 pixels, from the left: 3 moves, 4 stands, 5 moves at an unknown speed.
cv::Mat instances() {
  cv::Mat instance(frame_size, CV_32SC1, cv::Scalar(0));
  for (int i = 0; i < 3; ++i) instance(cv::Rect(30 * i, 0, 30, 40)).setTo(3 + i);
  return instance;
}
runner::TruthEntry truth() {
  runner::TruthEntry entry;
  entry.objects = {{3, {true, 5}}, {4, {false, 0}}, {5, {true, -1}}};
  return entry;
}

TEST(Starts, CountObjectsByTheLabelOfMostPixels) {
  HandMadeResult answer(frame_size);
  answer.add(1, State::Moving, {0, 0, 30, 40});
  answer.add(2, State::Moving, {30, 0, 30, 25});
  answer.add(3, State::Static, {30, 25, 30, 15});
  answer.add(4, State::Static, {60, 0, 30, 14});  // 35 % of it
  StartScore score;
  EXPECT_EQ(score.add(truth(), instances(), answer.result(), 1), 3);
  EXPECT_EQ(score.standing, 1);
  EXPECT_EQ(score.standing_moving, 1);
  EXPECT_EQ(score.moving, 2);
  EXPECT_EQ(score.moving_moving, 1);
  EXPECT_EQ(score.moving_static, 1);
}

TEST(Starts, LeaveOutWhatIsSmallSlowOrHardlyLabelled) {
  HandMadeResult answer(frame_size);
  answer.add(1, State::Moving, {30, 0, 30, 11});  // 27 % of the standing object
  StartScore score;
  EXPECT_EQ(score.add(truth(), instances(), answer.result(), 6), 0);
  EXPECT_EQ(score.standing, 1);
  EXPECT_EQ(score.standing_moving, 0);
  EXPECT_EQ(score.moving, 1) << "5 m/s are too slow, an unknown speed counts";
  cv::Mat small(frame_size, CV_32SC1, cv::Scalar(0));
  small(cv::Rect(0, 0, 19, 10)).setTo(4);
  StartScore none;
  none.add(truth(), small, answer.result(), 1);
  EXPECT_EQ(none.standing, 0);
}

TEST(Starts, ACameraIsWrongBeyondTenCentimetresAndFifteenPercent) {
  const auto ahead = [](double z) {
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    T(2, 3) = z;
    return T;
  };
  StartScore score;
  score.add(ahead(-0.2), ahead(-0.29), true);
  score.add(ahead(-2), ahead(-2.29), true);
  EXPECT_EQ(score.wrong, 0);
  score.add(ahead(-2), ahead(-2.31), false);
  score.add(ahead(-0.2), ahead(-0.31), true);
  EXPECT_EQ(score.intervals, 4);
  EXPECT_EQ(score.wrong, 2);
  EXPECT_EQ(score.silent, 1);
}

TEST(Starts, TheLargestMoverHasTheMostPixels) {
  cv::Mat instance = instances();
  EXPECT_EQ(largest_mover(truth(), instance, 1), 3) << "the first of equals";
  instance(cv::Rect(0, 30, 30, 10)).setTo(0);
  EXPECT_EQ(largest_mover(truth(), instance, 1), 5);
  EXPECT_EQ(largest_mover(truth(), cv::Mat(frame_size, CV_32SC1, cv::Scalar(4)), 1), -1);
}

TEST(Starts, PoolAddsUp) {
  StartScore one;
  one.starts = 2, one.standing = 3, one.moving_static = 1, one.silent = 1;
  StartScore sum = one;
  sum.add(one);
  EXPECT_EQ(sum.starts, 4);
  EXPECT_EQ(sum.standing, 6);
  EXPECT_EQ(sum.moving_static, 2);
  EXPECT_EQ(sum.silent, 2);
}

}  // namespace
}  // namespace eval
