// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/object_score.hpp"
#include "support/hand_made_result.hpp"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace eval {
namespace {

using dot::State;

const cv::Size frame_size(60, 40);
const cv::Rect place_a(0, 0, 20, 20);  // 400 pixels each
const cv::Rect place_b(30, 0, 20, 20);

/// Truth of one frame: objects on a depth of 10 m.
struct Scene {
  runner::RecordingEntry entry;
  runner::FrameTruth truth;

  explicit Scene(int number) {
    entry.number = number;
    entry.timestamp = 0.1 * number;
    truth.instance = cv::Mat(frame_size, CV_32SC1, cv::Scalar(0));
    truth.depth = cv::Mat(frame_size, CV_32FC1, cv::Scalar(10));
    truth.measured = truth.depth.clone();
  }

  void add(int id, const cv::Rect& area, bool moving, double speed) {
    truth.instance(area).setTo(id);
    entry.truth.objects[id] = {moving, speed};
  }
};

/// Two frames of the same scene; objects count from the second.
ObjectScore score_twice(Scene scene, const HandMadeResult& answer, const ObjectScoring& scoring = {}) {
  ObjectScorer scorer(scoring);
  scorer.add(scene.entry, scene.truth, nullptr, answer.result());
  const runner::TruthEntry previous = scene.entry.truth;
  ++scene.entry.number;
  scorer.add(scene.entry, scene.truth, &previous, answer.result());
  return scorer.score();
}

TEST(ObjectScore, CountsAnswersByTruth) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  scene.add(2, place_b, false, 0);
  scene.add(3, {0, 25, 20, 10}, true, 5);  // 200 pixels, no track
  HandMadeResult answer(frame_size);
  answer.add(7, State::Moving, place_a);
  answer.add(8, State::Static, place_b);
  const ObjectScore score = score_twice(scene, answer);
  EXPECT_EQ(score.confusion.total(), 3);
  EXPECT_EQ(score.confusion.of_moving(Answer::Moving), 1);
  EXPECT_EQ(score.confusion.of_moving(Answer::Missed), 1);
  EXPECT_EQ(score.confusion.of_standing(Answer::Static), 1);
  EXPECT_DOUBLE_EQ(score.confusion.precision(), 1);
  EXPECT_DOUBLE_EQ(score.confusion.recall(), 0.5);
  EXPECT_DOUBLE_EQ(score.confusion.f1(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.confusion.decided_share(), 2.0 / 3);
  EXPECT_EQ(at_all_ranges(score.by_speed[6])[static_cast<std::size_t>(Answer::Moving)], 1);  // 3 to 8 m/s
  EXPECT_EQ(at_all_ranges(score.by_speed[0])[static_cast<std::size_t>(Answer::Static)], 1);
  EXPECT_EQ(score.bands[0].confusion.total(), 3);
}

TEST(ObjectScore, NoRightAnswerIsAnF1OfZero) {
  Confusion confusion;
  EXPECT_TRUE(std::isnan(confusion.f1()));
  confusion.add(true, Answer::Missed);
  EXPECT_DOUBLE_EQ(confusion.f1(), 0);
  confusion.add(false, Answer::Moving);
  EXPECT_DOUBLE_EQ(confusion.f1(), 0);
}

TEST(ObjectScore, SmallAndNewObjectsDoNotCount) {
  Scene scene(0);
  scene.add(1, {0, 0, 20, 9}, true, 5);  // 180 pixels
  HandMadeResult answer(frame_size);
  EXPECT_EQ(score_twice(scene, answer).confusion.total(), 0);

  Scene large(0);
  large.add(1, place_a, true, 5);
  ObjectScorer scorer({});
  scorer.add(large.entry, large.truth, nullptr, answer.result());
  EXPECT_EQ(scorer.score().confusion.total(), 0);
  EXPECT_EQ(scorer.score().sightings.size(), 1U);
}

TEST(ObjectScore, ATrackMustCoverAQuarter) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  HandMadeResult little(frame_size);
  little.add(7, State::Moving, {0, 0, 9, 11});  // 99 of 400
  EXPECT_EQ(score_twice(scene, little).confusion.of_moving(Answer::Missed), 1);
  HandMadeResult enough(frame_size);
  enough.add(7, State::Moving, {0, 0, 10, 10});
  EXPECT_EQ(score_twice(scene, enough).confusion.of_moving(Answer::Moving), 1);
}

TEST(ObjectScore, SlowMoversCountBySpeedAlone) {
  Scene scene(0);
  scene.add(1, place_a, true, 0.7);
  HandMadeResult answer(frame_size);
  answer.add(7, State::Moving, place_a);
  const ObjectScore score = score_twice(scene, answer);
  EXPECT_EQ(score.confusion.total(), 0);
  EXPECT_EQ(at_all_ranges(score.by_speed[4])[static_cast<std::size_t>(Answer::Moving)], 1);  // 0.5 to 1 m/s
  EXPECT_EQ(score.pixels[1].moving, 0);
  EXPECT_EQ(score.pixels[1].wrong, 0);
  ObjectScoring slower;
  slower.min_speed = 0.5;
  EXPECT_EQ(score_twice(scene, answer, slower).confusion.total(), 1);
}

TEST(ObjectScore, ObjectsWithoutMeasuredDepthAreLeftOut) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  scene.truth.measured(place_a).setTo(0);
  scene.truth.measured({0, 0, 29, 1}).setTo(10);
  HandMadeResult answer(frame_size);
  const ObjectScore score = score_twice(scene, answer);
  EXPECT_EQ(score.no_depth, 1);
  EXPECT_EQ(score.confusion.total(), 0);
}

TEST(ObjectScore, MaskIou) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  HandMadeResult answer(frame_size);
  answer.add(7, State::Moving, {10, 0, 20, 20});  // half on the mover, half beside it
  const ObjectScore score = score_twice(scene, answer);
  EXPECT_EQ(score.pixels[1].correct, 200);
  EXPECT_EQ(score.pixels[1].wrong, 200);
  EXPECT_EQ(score.pixels[1].missed(), 200);
  EXPECT_DOUBLE_EQ(score.mask_iou(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(mean(score.instance_iou), 1.0 / 3);
}

TEST(ObjectScore, SwitchesOfTheIdAreCounted) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  ObjectScorer scorer({});
  for (const std::uint32_t id : {7U, 7U, 9U, 9U, 9U, 7U}) {
    HandMadeResult answer(frame_size);
    answer.add(id, State::Moving, place_a);
    scorer.add(scene.entry, scene.truth, nullptr, answer.result());
    ++scene.entry.number;
  }
  EXPECT_EQ(scorer.score().id_switches, 2);
}

TEST(ObjectScore, CalibrationAndCoverage) {
  Scene scene(0);
  scene.add(1, place_a, false, 0);
  scene.add(2, place_b, true, 4);
  HandMadeResult answer(frame_size);
  dot::ObjectResult& parked = answer.add(7, State::Static, place_a);
  parked.reason = dot::Reason::None;
  parked.velocity = {0.3, 0, 0.4};
  parked.speed = 0.5;
  parked.velocity_covariance = {0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.04};
  answer.add(8, State::Moving, place_b);  // no motion measured
  const ObjectScore score = score_twice(scene, answer);
  ASSERT_EQ(score.bands[0].static_nees.size(), 1U);
  EXPECT_NEAR(score.bands[0].static_nees[0], 9 + 4, 1e-12);
  EXPECT_NEAR(score.bands[0].nees_per_axis(), 13.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(score.bands[0].within_95(), 0);
  EXPECT_DOUBLE_EQ(score.speed_coverage(), 0.5);
  EXPECT_TRUE(score.bands[0].moving_speed_error.empty());
}

// What creeps, or has just stopped, has a velocity: it tells nothing of the sigma.
TEST(ObjectScore, CalibrationIsThatOfThingsThatStandStill) {
  for (const double true_speed : {0.0, -1.0, 0.02}) {  // negative: not known
    Scene scene(0);
    scene.add(1, place_a, false, true_speed);
    HandMadeResult answer(frame_size);
    dot::ObjectResult& slow = answer.add(7, State::Static, place_a);
    slow.reason = dot::Reason::None;
    slow.velocity = {0.02, 0, 0};
    slow.speed = 0.02;
    slow.velocity_covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4};
    const ObjectScore score = score_twice(scene, answer);
    EXPECT_EQ(score.bands[0].static_nees.size(), true_speed > 0 ? 0U : 1U) << true_speed;
    EXPECT_EQ(score.bands[0].static_speed.size(), true_speed > 0 ? 0U : 1U) << true_speed;
  }
}

TEST(ObjectScore, SpeedAndMotionErrorOfMovers) {
  Scene scene(0);
  scene.add(1, place_a, true, 4);
  scene.entry.truth.camera = Eigen::Matrix4d::Identity();
  scene.entry.truth.poses[1] = Eigen::Matrix4d::Identity();  // stands still from frame to frame
  HandMadeResult answer(frame_size);
  dot::ObjectResult& mover = answer.add(7, State::Moving, place_a);
  mover.reason = dot::Reason::None;
  mover.speed = 4.5;
  mover.T_o[3] = 0.3;
  const ObjectScore score = score_twice(scene, answer);
  ASSERT_EQ(score.bands[0].motion_error_m.size(), 1U);
  EXPECT_NEAR(score.bands[0].motion_error_m[0], 0.3, 1e-12);
  EXPECT_NEAR(score.bands[0].motion_error_deg[0], 0, 1e-12);
  EXPECT_NEAR(score.bands[0].moving_speed_error[0], 0.5, 1e-12);
}

TEST(ObjectScore, CountsWhatTurns) {
  for (const double degrees : {1.5, 2.5, 178.0}) {
    Scene scene(0);
    scene.add(1, place_a, true, 0.1);
    scene.add(2, place_b, true, 0.1);
    HandMadeResult answer(frame_size);
    answer.add(7, State::Moving, place_a);
    answer.add(8, State::Static, place_b);
    for (const int id : {1, 2}) scene.entry.truth.poses[id] = Eigen::Matrix4d::Identity();
    ObjectScorer scorer({});
    scorer.add(scene.entry, scene.truth, nullptr, answer.result());
    const runner::TruthEntry previous = scene.entry.truth;
    ++scene.entry.number;
    scene.entry.timestamp += 0.1;
    for (const int id : {1, 2})
      scene.entry.truth.poses[id].topLeftCorner<3, 3>() =
          Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180, Eigen::Vector3d(0.6, 0, 0.8)).toRotationMatrix();
    scorer.add(scene.entry, scene.truth, &previous, answer.result());
    const Confusion& turning = scorer.score().turning;
    EXPECT_EQ(turning.of_moving(Answer::Moving), degrees > 2 ? 1 : 0) << degrees;
    EXPECT_EQ(turning.of_moving(Answer::Static), degrees > 2 ? 1 : 0) << degrees;
  }
}

TEST(ObjectScore, RangeIsTheMedianDepthInsideTheMask) {
  Scene scene(0);
  scene.add(1, place_a, false, 0);
  scene.truth.depth(cv::Rect(0, 0, 20, 11)).setTo(40);
  HandMadeResult answer(frame_size);
  const ObjectScore score = score_twice(scene, answer);
  EXPECT_EQ(score.bands[2].confusion.total(), 1);
  EXPECT_DOUBLE_EQ(score.sightings[0].range, 40);
}

TEST(ObjectScore, FramesBeforeTheFirstAreLeftOut) {
  Scene scene(0);
  scene.add(1, place_a, true, 5);
  ObjectScoring late;
  late.from = 2;
  const ObjectScore score = score_twice(scene, HandMadeResult(frame_size), late);
  EXPECT_EQ(score.confusion.total(), 0);
  EXPECT_TRUE(score.pixels.empty());
}

}  // namespace
}  // namespace eval
