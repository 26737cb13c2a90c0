// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/opencv.hpp"

#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "dot/image/image.hpp"

namespace {

TEST(OpencvSurface, FrameBorrowsTheImages) {
  const cv::Mat image(20, 30, CV_8UC3, cv::Scalar(1, 2, 3));
  const cv::Mat depth(20, 30, CV_16UC1, cv::Scalar(2560));
  const dot::Frame frame = dot::make_frame(7, 1.5, image, depth, 256);
  EXPECT_EQ(frame.id, 7U);
  EXPECT_EQ(frame.timestamp, 1.5);
  EXPECT_EQ(frame.image.data, image.data);
  EXPECT_EQ(frame.image.format, dot::PixelFormat::Bgr8);
  EXPECT_EQ(frame.depth.data, depth.data);
  EXPECT_EQ(frame.depth.format, dot::PixelFormat::DepthU16);
  EXPECT_EQ(frame.depth.depth_units_per_metre, 256);
  EXPECT_FALSE(frame.masks.has_value());
  EXPECT_FALSE(frame.camera_motion.has_value());
  EXPECT_THROW(dot::make_frame(0, 0, image, image), std::invalid_argument);
}

TEST(OpencvSurface, MasksHaveOneValueEachAndOppositePolarity) {
  dot::Image<std::uint8_t> labels(30, 20);
  labels.fill(0);
  labels(10, 5) = static_cast<std::uint8_t>(dot::State::Moving);
  labels(20, 5) = static_cast<std::uint8_t>(dot::State::Static);
  const dot::Image<std::uint8_t>& read_only = labels;
  dot::Result result;
  result.labels = read_only.view();

  dot::ExclusionPolicy policy;
  policy.dilation = 1;
  const cv::Mat exclude = dot::exclusion_mask(result, policy);
  const cv::Mat features = dot::feature_mask(result, policy);
  ASSERT_EQ(exclude.type(), CV_8UC1);
  ASSERT_EQ(exclude.size(), cv::Size(30, 20));
  EXPECT_EQ(cv::countNonZero(exclude), 9);
  EXPECT_EQ(cv::countNonZero(exclude(cv::Rect(9, 4, 3, 3)) == 255), 9);
  EXPECT_EQ(cv::countNonZero(features == 255), 30 * 20 - 9);
  EXPECT_EQ(cv::countNonZero((exclude == 0) != (features == 255)), 0);

  policy.exclude_static = true;
  EXPECT_EQ(cv::countNonZero(dot::exclusion_mask(result, policy)), 18);
}

}  // namespace
