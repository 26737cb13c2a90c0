// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot_eval/boxes.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "dot_eval/arguments.hpp"
#include "sequence/errors.hpp"

namespace eval {
namespace {

/// Two instances that touch; the second one has a class.
runner::SequenceFrame two_instances() {
  runner::SequenceFrame frame;
  frame.ids = cv::Mat::zeros(40, 60, CV_16U);
  for (int y = 10; y < 20; ++y)
    for (int x = 5; x < 25; ++x) frame.ids.at<std::uint16_t>(y, x) = x + y < 30 ? 3 : 9;
  dot::Instance known;
  known.id = 9;
  known.class_id = 4;
  known.always_dynamic = true;
  frame.instances = {known};
  return frame;
}

TEST(Boxes, AreThoseOfTheMasks) {
  runner::SequenceFrame frame = two_instances();
  make_boxes(0, frame);
  const dot::Frame given = frame.frame();
  ASSERT_TRUE(given.masks);
  EXPECT_EQ(given.masks->ids.data, nullptr);
  ASSERT_EQ(given.masks->instances.size, 2U);
  const dot::Instance &first = given.masks->instances.data[0], &second = given.masks->instances.data[1];
  EXPECT_EQ(first.id, 3U);
  EXPECT_EQ(cv::Rect(first.x, first.y, first.mask.width, first.mask.height), cv::Rect(5, 10, 15, 10));
  EXPECT_EQ(first.class_id, -1);
  EXPECT_EQ(second.id, 9U);
  EXPECT_EQ(cv::Rect(second.x, second.y, second.mask.width, second.mask.height), cv::Rect(11, 10, 14, 10));
  EXPECT_EQ(second.class_id, 4);
  EXPECT_TRUE(second.always_dynamic);
  const auto* pixels = static_cast<const std::uint8_t*>(second.mask.data);
  for (int y = 0; y < second.mask.height; ++y)
    for (int x = 0; x < second.mask.width; ++x) ASSERT_EQ(pixels[y * second.mask.stride + x], 255) << x << ' ' << y;
}

TEST(Boxes, StayInTheImageWithTheirMargin) {
  runner::SequenceFrame frame = two_instances();
  make_boxes(0.5, frame);
  const dot::Instance& first = frame.instances[0];
  EXPECT_EQ(cv::Rect(first.x, first.y, first.mask.width, first.mask.height), cv::Rect(0, 5, 27, 20));
}

TEST(Boxes, OfNoMaskAreNone) {
  runner::SequenceFrame none;
  make_boxes(0, none);
  EXPECT_FALSE(none.frame().masks) << "no segmentation";
  none.ids = cv::Mat::zeros(40, 60, CV_16U);
  make_boxes(0, none);
  ASSERT_TRUE(none.frame().masks) << "the network saw nothing";
  EXPECT_EQ(none.frame().masks->instances.size, 0U);
}

TEST(Boxes, NeedAMargin) {
  const auto given = [](const char* margin) {
    const char* const line[] = {"dot_eval", "/d/a", "--boxes", margin};
    return parse_arguments(4, line).boxes;
  };
  EXPECT_EQ(given("0.25"), 0.25);
  for (const char* wrong : {"-0.1", "1.5", "wide", "nan"}) EXPECT_THROW(given(wrong), runner::UsageError) << wrong;
}

}  // namespace
}  // namespace eval
