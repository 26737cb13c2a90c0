// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/explanation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

namespace player {
namespace {

dot::ObjectResult object(dot::State state, double p_moving) {
  dot::ObjectResult o;
  o.state = state;
  o.p_moving = p_moving;
  o.reason = dot::Reason::None;
  o.speed = 3;
  o.velocity = {0, 0, 3};
  o.velocity_covariance = {1, 0, 0, 0, 1, 0, 0, 0, 0.04};
  o.range = 20;
  return o;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Explanation, EachReasonHasItsOwnWords) {
  std::set<std::string> words;
  for (int i = 0; i <= static_cast<int>(dot::Reason::TooManyObjects); ++i)
    words.insert(in_words(static_cast<dot::Reason>(i)));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(dot::Reason::TooManyObjects) + 1);
  EXPECT_EQ(words.count(""), 0U);
  EXPECT_STREQ(in_words(static_cast<dot::Reason>(200)), "?");
  EXPECT_STREQ(in_words(dot::Reason::Occluded), "nearer objects hide too much of it");
  EXPECT_STREQ(in_words(dot::Reason::CameraLost), "the camera's motion was not found");
}

TEST(Explanation, EachCameraStatusHasItsOwnWords) {
  std::set<std::string> words;
  for (int i = 0; i <= static_cast<int>(dot::CameraStatus::Lost); ++i)
    words.insert(in_words(static_cast<dot::CameraStatus>(i)));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(dot::CameraStatus::Lost) + 1);
}

TEST(Explanation, OfDecidedObjectsByTheThresholds) {
  const dot::Options options;
  EXPECT_EQ(
      explanation(object(dot::State::Moving, 0.95), options),
      "Measured 3.00 m/s (sigma 0.20) at 20.0 m; faster than 0.50 m/s counts as moving. P(moving) is 0.950, above "
      "0.9: moving.");
  EXPECT_TRUE(has(explanation(object(dot::State::Moving, 0.85), options), "still above 0.8: it stays moving."));
  EXPECT_TRUE(has(explanation(object(dot::State::Static, 0.03), options), "P(moving) is 0.030, below 0.1: static."));
  EXPECT_TRUE(has(explanation(object(dot::State::Static, 0.15), options), "still below 0.2: it stays static."));
}

TEST(Explanation, NearObjectsHaveALowerLimit) {
  dot::ObjectResult near = object(dot::State::Moving, 0.95);
  near.range = 4;
  EXPECT_TRUE(has(explanation(near, {}), "faster than 0.080 m/s counts as moving"));
}

TEST(Explanation, WhyNotDecided) {
  const dot::Options options;
  dot::ObjectResult o = object(dot::State::NotObservable, 0.63);
  EXPECT_TRUE(
      has(explanation(o, options), "P(moving) is 0.630: not decided. Above 0.9 it would be moving, below 0.1 static."));
  EXPECT_TRUE(has(explanation(o, options), "This frame alone speaks for moving, but"));
  o.speed = 0.01;
  EXPECT_TRUE(has(explanation(o, options), "This frame alone speaks for static, but"));
  o.velocity_covariance[8] = 4;
  EXPECT_TRUE(has(explanation(o, options), "With this sigma the speed may be on either side of the limit"));
  o.reason = dot::Reason::TooLittleTexture;
  o.last_decided = dot::State::Static;
  EXPECT_EQ(
      explanation(o, options),
      "Not measured in this frame: it has too little texture. P(moving) is 0.630: not decided. Above 0.9 it would "
      "be moving, below 0.1 static. It was last decided: static.");
}

/// On the spot, 2 m away.
dot::ObjectResult turning(dot::State state, double p_moving) {
  dot::ObjectResult o = object(state, p_moving);
  o.speed = 0;
  o.velocity = {};
  o.velocity_covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4};
  o.range = 2;
  o.point_speed = 0.11;
  o.point_speed_sigma = std::sqrt(0.022 * 0.022 + 3e-4);
  return o;
}

TEST(Explanation, OfWhatMovesBecauseItTurns) {
  const dot::ObjectResult o = turning(dot::State::Moving, 0.95);
  EXPECT_EQ(
      explanation(o, {}),
      "Measured 0.000 m/s (sigma 0.010) at 2.0 m; turning moves its points by 0.110 m/s (sigma 0.022); faster than "
      "0.020 m/s counts as moving. P(moving) is 0.950, above 0.9: moving.");
  dot::Options without;
  without.velocity.most_turning = 0;
  EXPECT_FALSE(has(explanation(o, without), "turning"));
  without.classifier = dot::ClassifierKind::Entropy;
  without.velocity.most_turning = 0.5;
  EXPECT_FALSE(has(explanation(o, without), "turning"));
}

TEST(Explanation, TurningSpeaksForMoving) {
  dot::ObjectResult o = turning(dot::State::NotObservable, 0.6);
  o.velocity_covariance = {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6};
  EXPECT_TRUE(has(explanation(o, {}), "This frame alone speaks for moving, but"));
  dot::Options without;
  without.velocity.most_turning = 0;
  EXPECT_TRUE(has(explanation(o, without), "This frame alone speaks for static, but"));
  o.point_speed_sigma = 0.05;
  EXPECT_TRUE(has(explanation(o, {}), "This frame alone speaks for static, but"));
}

TEST(Explanation, OfAClassThatAlwaysMoves) {
  dot::ObjectResult o = object(dot::State::Moving, 1);
  o.always_dynamic = true;
  EXPECT_TRUE(has(explanation(o, {}), "Its class always counts as moving."));
}

TEST(Explanation, ByThePapersRule) {
  dot::Options options;
  options.classifier = dot::ClassifierKind::Entropy;
  dot::ObjectResult o = object(dot::State::Moving, 1);
  o.disparity_px = 2.5;
  o.disparity_noise_px = 0.5;
  o.entropy = -16.5;
  EXPECT_TRUE(has(explanation(o, options),
                  "its points move by 2.5 px, the limit is 1.5 px; the entropy is -16.5 nats, it "
                  "must be below -14.0. It is moving."));
  options.classifier = dot::ClassifierKind::EntropyLiteral;
  EXPECT_TRUE(has(explanation(o, options), "it must be above -25.0."));
  o.reason = dot::Reason::Hidden;
  EXPECT_TRUE(has(explanation(o, options), "It is moving, as before."));
}

TEST(SigmaOfLength, IsThatAlongTheVector) {
  const std::array<double, 9> covariance{1, 0.5, 0, 0.5, 4, 0, 0, 0, 9};
  EXPECT_DOUBLE_EQ(sigma_of_length({5, 0, 0}, covariance), 1);
  EXPECT_DOUBLE_EQ(sigma_of_length({0, -2, 0}, covariance), 2);
  EXPECT_DOUBLE_EQ(sigma_of_length({1, 1, 0}, covariance), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(sigma_of_length({0, 0, 0}, covariance), 3) << "no direction: the largest";
}

}  // namespace
}  // namespace player
