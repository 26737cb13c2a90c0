// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/frame_data.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "wall.hpp"

namespace player {
namespace {

/// The data as another reader of JSON understands it.
cv::FileStorage parsed(const page::Json& data) {
  std::ostringstream text;
  data.write(text, page::Json::one_line);
  EXPECT_EQ(text.str().find('\n'), std::string::npos);
  EXPECT_EQ(text.str().find("null"), std::string::npos) << text.str();
  return cv::FileStorage(text.str(), cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_JSON);
}

std::vector<double> numbers(const cv::FileNode& list) {
  std::vector<double> values;
  list >> values;
  return values;
}

bool is_there(const cv::FileNode& object, const char* name) { return !object[name].empty(); }

TEST(FrameData, OfAMeasuredObject) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 4, dot::State::Moving, {40, 30, 20, 16});
  object.class_id = 2;
  object.score = 0.75F;
  object.segmented = true;
  object.point_speed = 2.5;
  object.point_speed_sigma = 1.25;
  object.fused_velocity = {0, 3, 4};
  object.fused_covariance = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  dot::Result result = tracked(hand_made);
  result.timestamp = 1.25;
  result.camera.T_cur_prev[11] = -0.6;
  result.camera.phi = 0.97;
  result.camera.n_points = 900;
  result.camera.n_inliers = 800;
  FrameDrawing drawing;
  drawing.predicted[4] = {{{1, 2}, {3, 4}, {5, 6}}};
  drawing.points[4] = {{41, 31}, {42, 32}};
  drawing.points[0] = {{1, 1}};

  const cv::FileStorage data = parsed(frame_data(wall(31), result, 6.125, drawing, {}));
  EXPECT_EQ(static_cast<int>(data["frame"]), 31);
  EXPECT_DOUBLE_EQ(data["time"].real(), 1.25);
  EXPECT_DOUBLE_EQ(data["interval"].real(), 0.1);
  EXPECT_NEAR(data["ms"].real(), 6.125, 0.006);
  EXPECT_EQ(data["camera"]["status"].string(), "tracked");
  EXPECT_DOUBLE_EQ(data["camera"]["speed"].real(), 6);
  EXPECT_DOUBLE_EQ(data["camera"]["phi"].real(), 0.97);
  EXPECT_EQ(static_cast<int>(data["camera"]["points"]), 900);
  EXPECT_EQ(static_cast<int>(data["camera"]["inliers"]), 800);
  EXPECT_EQ(numbers(data["texture"]), (std::vector<double>{1, 1}));

  ASSERT_EQ(data["objects"].size(), 1U);
  const cv::FileNode o = data["objects"][0];
  EXPECT_EQ(static_cast<int>(o["id"]), 4);
  EXPECT_EQ(o["state"].string(), "moving");
  EXPECT_EQ(o["words"].string(), "measured");
  EXPECT_EQ(o["why"].string().substr(0, 18), "Measured 2.00 m/s ");
  EXPECT_EQ(o["decided"].string(), "moving");
  EXPECT_EQ(static_cast<int>(o["class"]), 2);
  EXPECT_DOUBLE_EQ(o["score"].real(), 0.75);
  EXPECT_EQ(static_cast<int>(o["area"]), 320);
  EXPECT_EQ(numbers(o["box"]), (std::vector<double>{40, 30, 20, 16}));
  EXPECT_DOUBLE_EQ(o["p"].real(), 0.97);
  EXPECT_DOUBLE_EQ(o["speed"].real(), 2);
  EXPECT_DOUBLE_EQ(o["sigma"].real(), 0.1);
  EXPECT_DOUBLE_EQ(o["pointSpeed"].real(), 2.5);
  EXPECT_DOUBLE_EQ(o["pointSigma"].real(), 1.25);
  EXPECT_FALSE(is_there(o, "turning"));
  EXPECT_DOUBLE_EQ(o["limit"].real(), 0.5);
  EXPECT_DOUBLE_EQ(o["phi"].real(), 0.95);
  EXPECT_DOUBLE_EQ(o["range"].real(), 10);
  EXPECT_EQ(static_cast<int>(o["points"]), 100);
  EXPECT_EQ(static_cast<int>(o["inliers"]), 80);
  EXPECT_DOUBLE_EQ(o["fused"].real(), 5);
  EXPECT_DOUBLE_EQ(o["fusedSigma"].real(), 1);
  EXPECT_EQ(numbers(o["outline"][0]), (std::vector<double>{40, 30, 40, 45, 59, 45, 59, 30}));
  EXPECT_EQ(numbers(o["predicted"][0]), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(numbers(o["texture"]), (std::vector<double>{41, 31, 42, 32}));
}

TEST(FrameData, WhatWasNotMeasuredIsAbsent) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = hand_made.add(9, dot::State::NotObservable, cv::Rect());
  object.reason = dot::Reason::Hidden;
  object.speed = object.phi = object.range = 5;  // left over
  dot::Result result = hand_made.result();
  result.camera.status = dot::CameraStatus::Lost;
  const cv::FileStorage data = parsed(frame_data(wall(0), result, 1, {}, {}));
  EXPECT_EQ(data["camera"]["status"].string(), "lost");
  EXPECT_FALSE(is_there(data["camera"], "speed"));
  EXPECT_FALSE(is_there(data["camera"], "phi"));
  EXPECT_TRUE(data["network"].empty());
  const cv::FileNode o = data["objects"][0];
  EXPECT_EQ(o["reason"].string(), "hidden");
  EXPECT_EQ(o["state"].string(), "unobservable");
  for (const char* name : {"speed", "sigma", "pointSpeed", "pointSigma", "turning", "limit", "phi", "range", "points",
                           "fused", "decided", "always", "discovered", "outline", "predicted", "texture"})
    EXPECT_FALSE(is_there(o, name)) << name;
}

TEST(FrameData, OfRevisedMotions) {
  const HandMadeResult nothing(frame_size);
  FrameDrawing drawing;
  EXPECT_FALSE(is_there(parsed(frame_data(wall(3), tracked(nothing), 1, drawing, {}))["camera"], "revised"));
  drawing.revised = {{1, 0.31}, {2, std::numeric_limits<double>::quiet_NaN()}};
  const cv::FileStorage data = parsed(frame_data(wall(3), tracked(nothing), 1, drawing, {}));
  const cv::FileNode revised = data["camera"]["revised"];
  ASSERT_EQ(revised.size(), 2U);
  EXPECT_EQ(static_cast<int>(revised[0]["frame"]), 1);
  EXPECT_DOUBLE_EQ(revised[0]["wrong"].real(), 0.31);
  EXPECT_EQ(static_cast<int>(revised[1]["frame"]), 2);
  EXPECT_FALSE(is_there(revised[1], "wrong"));
}

TEST(FrameData, OfAnObjectThatTurns) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 4, dot::State::Moving, {40, 30, 20, 16});
  object.point_speed = 5;
  EXPECT_TRUE(is_there(parsed(frame_data(wall(0), tracked(hand_made), 1, {}, {}))["objects"][0], "turning"));
}

TEST(FrameData, NumbersThatAreNoneAreAbsent) {
  HandMadeResult hand_made(frame_size);
  dot::ObjectResult& object = add_measured(hand_made, 1, dot::State::Moving, {40, 30, 20, 16});
  object.speed = std::numeric_limits<double>::quiet_NaN();
  object.range = std::numeric_limits<double>::infinity();
  const cv::FileStorage data = parsed(frame_data(wall(0), tracked(hand_made), 1, {}, {}));
  EXPECT_FALSE(is_there(data["objects"][0], "speed"));
  EXPECT_FALSE(is_there(data["objects"][0], "range"));
}

TEST(FrameData, OfASegmentation) {
  runner::SequenceFrame frame = wall(0);
  frame.ids = cv::Mat(frame_size, CV_8UC1, cv::Scalar(0));
  const HandMadeResult nothing(frame_size);
  EXPECT_EQ(parsed(frame_data(frame, nothing.result(), 1, {}, {}))["network"].size(), 0U);
  frame.ids(cv::Rect(10, 10, 5, 5)).setTo(3);
  frame.ids(cv::Rect(30, 10, 5, 5)).setTo(4);
  const cv::FileStorage data = parsed(frame_data(frame, nothing.result(), 1, {}, {}));
  ASSERT_EQ(data["network"].size(), 2U);
  EXPECT_EQ(numbers(data["network"][1][0]), (std::vector<double>{30, 10, 30, 14, 34, 14, 34, 10}));
  EXPECT_EQ(data["objects"].size(), 0U);
}

}  // namespace
}  // namespace player
