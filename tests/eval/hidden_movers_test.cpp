// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/hidden_movers.hpp"
#include "support/hand_made_result.hpp"

#include <gtest/gtest.h>

namespace eval {
namespace {

using dot::State;

const cv::Size frame_size(120, 60);
const cv::Rect first(0, 0, 40, 30);  // 1,200 pixels each
const cv::Rect second(60, 0, 40, 30);

/// Movers 3 and 5; 4 stands. 5 is the second mover, hence hidden.
runner::Recording recording() {
  runner::Recording recording;
  recording.entries.resize(1);
  recording.entries[0].masks = "masks/000000.png";
  recording.entries[0].truth.objects = {{3, {true, 5}}, {4, {false, 0}}, {5, {true, 5}}};
  return recording;
}

cv::Mat instances() {
  cv::Mat instance(frame_size, CV_32SC1, cv::Scalar(0));
  instance(first).setTo(3);
  instance(second).setTo(5);
  return instance;
}

runner::SequenceFrame frame_with_masks() {
  runner::SequenceFrame frame;
  frame.ids = cv::Mat(frame_size, CV_8UC1, cv::Scalar(0));
  frame.ids(first).setTo(11);
  frame.ids(second).setTo(12);
  frame.instances.resize(2);
  frame.instances[0].id = 11;
  frame.instances[1].id = 12;
  return frame;
}

TEST(HiddenMovers, EverySecondMoverIsTakenOutOfTheMasks) {
  const HiddenMovers hidden(recording(), {});
  EXPECT_EQ(hidden.score().movers, 1);
  runner::SequenceFrame frame = frame_with_masks();
  hidden.remove(frame, instances());
  EXPECT_EQ(cv::countNonZero(frame.ids == 11), first.area());
  EXPECT_EQ(cv::countNonZero(frame.ids == 12), 0);
  ASSERT_EQ(frame.instances.size(), 1U);
  EXPECT_EQ(frame.instances[0].id, 11U);
}

TEST(HiddenMovers, AnInstanceIsTakenOutFromOneHalfOn) {
  const HiddenMovers hidden(recording(), {});
  runner::SequenceFrame half = frame_with_masks();
  half.ids(cv::Rect(60, 30, 40, 30)).setTo(12);  // as large again, below the mover
  hidden.remove(half, instances());
  EXPECT_EQ(cv::countNonZero(half.ids == 12), 0);
  runner::SequenceFrame less = frame_with_masks();
  less.ids(cv::Rect(60, 30, 41, 30)).setTo(12);
  hidden.remove(less, instances());
  EXPECT_GT(cv::countNonZero(less.ids == 12), 0);
}

TEST(HiddenMovers, CountFromTheSixthFrame) {
  HiddenMovers hidden(recording(), {});
  HandMadeResult answer(frame_size);
  answer.add(7, State::Moving, {60, 0, 40, 20});  // 800 of the hidden mover's pixels
  answer.add(8, State::Moving, {0, 40, 10, 10});  // on nothing that moves
  const runner::RecordingEntry entry = recording().entries[0];
  for (int i = 0; i < 5; ++i) hidden.add(entry, instances(), answer.result());
  EXPECT_EQ(hidden.score().pixels, 0);
  for (int i = 0; i < 2; ++i) hidden.add(entry, instances(), answer.result());
  EXPECT_EQ(hidden.score().pixels, 2 * 1200);
  EXPECT_DOUBLE_EQ(hidden.score().found_share(), 800.0 / 1200);
  EXPECT_EQ(hidden.score().standing, 7L * (frame_size.area() - 2 * 1200));
  EXPECT_EQ(hidden.score().false_alarm, 7 * 100);
  EXPECT_DOUBLE_EQ(hidden.score().outside_share(), 100.0 / 900);
}

TEST(HiddenMovers, FramesThatAreLeftOutDoNotCount) {
  HiddenMovers hidden(recording(), {1, 7});
  HandMadeResult answer(frame_size);
  answer.add(7, State::Moving, {60, 0, 40, 20});
  answer.add(8, State::Moving, {0, 40, 10, 10});
  runner::RecordingEntry entry = recording().entries[0];
  for (entry.number = 0; entry.number < 7; ++entry.number) hidden.add(entry, instances(), answer.result());
  EXPECT_EQ(hidden.score().pixels, 0);
  EXPECT_EQ(hidden.score().standing, 0);
  EXPECT_EQ(hidden.score().false_alarm, 0);
  hidden.add(entry, instances(), answer.result());
  EXPECT_EQ(hidden.score().pixels, 1200) << "the sixth frame in which it was seen has passed";
  EXPECT_EQ(hidden.score().false_alarm, 100);
}

TEST(HiddenMovers, WithoutMasksAllMoversAreHidden) {
  runner::Recording without = recording();
  without.entries[0].masks.clear();
  HiddenMovers hidden(without, {});
  EXPECT_EQ(hidden.score().movers, 2);
  for (int i = 0; i < 6; ++i) hidden.add(without.entries[0], instances(), HandMadeResult(frame_size).result());
  EXPECT_EQ(hidden.score().pixels, 2 * 1200);
}

TEST(HiddenMovers, SlowFramesDoNotCount) {
  HiddenMovers hidden(recording(), {});
  runner::RecordingEntry entry = recording().entries[0];
  entry.truth.objects[5].speed = 0.9;
  for (int i = 0; i < 8; ++i) hidden.add(entry, instances(), HandMadeResult(frame_size).result());
  EXPECT_EQ(hidden.score().pixels, 0);
}

}  // namespace
}  // namespace eval
