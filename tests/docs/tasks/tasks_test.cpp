// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The C++ of docs/tasks.md on the sample: what lies between "snippet:" and "end of snippet" is replaced by the page's.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "dot/opencv.hpp"
#include "support/lorry.hpp"
#include "support/sample.hpp"

namespace {

const dot::test::Sample& sample() {
  static const dot::test::Sample read{DOT_SAMPLE_DIR};
  return read;
}

TEST(Tasks, Exclude) {
  dot::Tracker tracker(sample().camera, dot::test::Sample::options());
  tracker.track(sample().frame(0));
  const dot::Result& result = tracker.track(sample().frame(1));
  // snippet: task_exclude
  // end of snippet
  const int excluded = cv::countNonZero(exclude), used = cv::countNonZero(use);
  EXPECT_GT(excluded, 0);
  EXPECT_LT(used, static_cast<int>(use.total()) - excluded) << "the other mask is wider";
  EXPECT_GT(used, 0);
}

TEST(Tasks, List) {
  struct Detection {
    cv::Mat mask;
    cv::Rect box;
    int class_id;
    float score;
  };
  constexpr int person = 0;
  const cv::Mat& ids = sample()[0].masks;
  double most = 0;
  cv::minMaxLoc(ids, nullptr, &most);
  std::vector<Detection> detections;
  for (int id = 1; id <= static_cast<int>(most); ++id) {
    const cv::Mat mask = ids == id;
    const cv::Rect box = cv::boundingRect(mask);
    if (box.area() > 0) detections.push_back({mask(box), box, detections.empty() ? person : 2, 0.9f});
  }
  ASSERT_GT(detections.size(), 1u);
  dot::Tracker tracker(sample().camera, dot::test::Sample::options());
  dot::Frame frame = sample().frame(0, false);
  // snippet: task_list
  // end of snippet
  const dot::Result& result = tracker.track(frame);
  for (const dot::ObjectResult& object : result.objects) {
    const Detection& detection = detections[object.instance_id - 1];
    EXPECT_EQ(object.state == dot::State::Moving, detection.class_id == person);
    EXPECT_EQ(object.area, cv::countNonZero(detection.mask));
    EXPECT_EQ(object.box[0], detection.box.x);
  }
  EXPECT_EQ(result.objects.size, detections.size());
}

TEST(Tasks, Late) {
  const dot::Frame frame = sample().frame(0, false), next = sample().frame(1, false), third = sample().frame(2, false);
  const dot::Masks masks{dot::id_view(sample()[0].masks), {}};
  dot::Tracker tracker(sample().camera, dot::test::Sample::options());
  // snippet: task_late
  // end of snippet
  ASSERT_FALSE(result.objects.empty());
  EXPECT_GT(result.objects[0].area, 0);
}

TEST(Tasks, Sparse) {
  const dot::Intrinsics intrinsics = sample().camera;
  dot::Frame frame = sample().frame(0);
  cv::Mat projected(sample()[0].depth.size(), CV_32FC1, cv::Scalar(0));
  for (int y = 2; y < projected.rows; y += 4)
    for (int x = 2; x < projected.cols; x += 6)
      projected.at<float>(y, x) = static_cast<float>(sample()[0].depth.at<std::uint16_t>(y, x)) / 256;
  // snippet: task_sparse
  // end of snippet
  EXPECT_FALSE(tracker.track(frame).too_little_depth);
}

TEST(Tasks, Prior) {
  dot::Tracker tracker(sample().camera, dot::test::Sample::options());
  tracker.track(sample().frame(0));
  dot::Frame frame = sample().frame(1);
  // snippet: task_prior
  // end of snippet
  EXPECT_EQ((*frame.camera_prior)[11], -0.8);
  EXPECT_EQ(tracker.track(frame).camera.status, dot::CameraStatus::Tracked);
}

TEST(Tasks, Revised) {
  dot::Tracker tracker(dot::test::small_camera(), dot::Options{});
  dot::test::Film<> film = dot::test::behind_a_lorry(dot::test::straight({0, 0, 0}, {0, 0, 3}), 1);
  std::map<std::uint64_t, double> edges;  // by frame, metres ahead
  const auto set_edge = [&](std::uint64_t frame_id, const std::array<double, 12>& T_cur_prev,
                            const std::array<double, 36>& covariance) {
    edges[frame_id] = -T_cur_prev[11];
    EXPECT_TRUE(frame_id == 0 || covariance[0] > 0) << frame_id;
  };
  for (int i = 0; i < 4; ++i) {
    const dot::Result& result = film.next(tracker);
    // snippet: task_revised
    // end of snippet
    if (i == 1) {
      EXPECT_GT(std::abs(edges[1] - 0.3), 0.3) << "the scene is too easy";
    }
  }
  for (const std::uint64_t frame : {1U, 2U, 3U}) EXPECT_NEAR(edges[frame], 0.3, 0.02) << frame;
}

TEST(Tasks, Why) {
  dot::Tracker tracker(sample().camera, dot::test::Sample::options());
  const dot::Result& result = tracker.track(sample().frame(0));
  testing::internal::CaptureStdout();
  // snippet: task_why
  // end of snippet
  EXPECT_NE(testing::internal::GetCapturedStdout().find("object 1: new, P(moving) 0."), std::string::npos);
}

}  // namespace
