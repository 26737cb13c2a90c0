// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/outlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "dot/image/opencv.hpp"

namespace player {
namespace {

/// The pixels that the outlines enclose.
cv::Mat filled(const Outlines& outlines, cv::Size size) {
  cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
  cv::fillPoly(mask, outlines, cv::Scalar(255));  // even-odd, with the border's pixels
  return mask;
}

TEST(Outlines, EncloseTheRegionAndItsHole) {
  cv::Mat mask(40, 50, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(5, 6, 30, 20)).setTo(1);
  mask(cv::Rect(15, 10, 8, 8)).setTo(0);
  const Outlines outlines = outlines_of(mask, {100, 200});
  ASSERT_EQ(outlines.size(), 2U);
  EXPECT_EQ(cv::boundingRect(outlines[0]), cv::Rect(105, 206, 30, 20));
  EXPECT_EQ(outlines[0].size(), 4U) << "straight lines need no more points";
  EXPECT_EQ(outlines_of(mask, {0, 0}, Holes::Fill).size(), 1U);
}

TEST(Outlines, ReachTheImageBorder) {
  const cv::Mat mask(10, 12, CV_8UC1, cv::Scalar(255));
  const Outlines outlines = outlines_of(mask, {0, 0});
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(cv::boundingRect(outlines[0]), cv::Rect(0, 0, 12, 10));
}

TEST(Outlines, FollowACurveWithinAPixel) {
  cv::Mat mask(100, 100, CV_8UC1, cv::Scalar(0));
  cv::circle(mask, {50, 50}, 30, cv::Scalar(255), cv::FILLED);
  const Outlines outlines = outlines_of(mask, {0, 0});
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_LT(outlines[0].size(), 60U);
  EXPECT_LT(cv::countNonZero(filled(outlines, mask.size()) != mask), 60);
}

TEST(Outlines, OfNothing) {
  EXPECT_TRUE(outlines_of(cv::Mat::zeros(5, 5, CV_8UC1), {0, 0}).empty());
  EXPECT_TRUE(boxes_of(cv::Mat::zeros(5, 5, CV_32SC1)).empty());
}

TEST(Outlines, BoxesById) {
  cv::Mat ids(20, 30, CV_32SC1, cv::Scalar(0));
  ids(cv::Rect(2, 3, 4, 5)).setTo(7);
  ids(cv::Rect(6, 3, 3, 2)).setTo(70000);
  ids.at<int>(19, 29) = 7;
  const auto boxes = boxes_of(ids);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes.at(7), cv::Rect(2, 3, 28, 17));
  EXPECT_EQ(boxes.at(70000), cv::Rect(6, 3, 3, 2));
}

TEST(Outlines, OfASegmentationAsImageAndAsList) {
  cv::Mat ids(20, 30, CV_16UC1, cv::Scalar(0));
  ids(cv::Rect(2, 3, 6, 5)).setTo(300);
  ids(cv::Rect(12, 3, 6, 5)).setTo(5);
  cv::Mat mask(6, 4, CV_8UC1, cv::Scalar(1));
  std::vector<dot::Instance> list(2);
  list[0].id = 5;  // class and score of an id of the image
  list[1].mask = dot::detail::image_ref(mask, dot::PixelFormat::Grey8);
  list[1].x = 20;
  list[1].y = 10;
  dot::Masks masks{dot::id_view(ids), {list.data(), list.size()}};
  const std::vector<Outlines> outlines = outlines_of(masks);
  ASSERT_EQ(outlines.size(), 3U);
  EXPECT_EQ(cv::boundingRect(outlines[0].at(0)), cv::Rect(12, 3, 6, 5));
  EXPECT_EQ(cv::boundingRect(outlines[1].at(0)), cv::Rect(2, 3, 6, 5));
  EXPECT_EQ(cv::boundingRect(outlines[2].at(0)), cv::Rect(20, 10, 4, 6));
  EXPECT_TRUE(outlines_of(dot::Masks{}).empty());
}

}  // namespace
}  // namespace player
