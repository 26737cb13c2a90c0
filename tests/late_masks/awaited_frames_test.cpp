// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/late_masks/awaited_frames.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <vector>

namespace {

using dot::AwaitedFrames;
using dot::CameraStep;
using dot::SE3d;

dot::FramePtr frame(std::uint64_t id, double timestamp) {
  auto out = std::make_shared<dot::FrameData>();
  out->id = id;
  out->timestamp = timestamp;
  return out;
}

/// Frames one second apart, that follow on one another.
AwaitedFrames frames(int count, double seconds, int most, double epoch = 0) {
  AwaitedFrames out;
  for (int i = 0; i < count; ++i) out.add(frame(static_cast<std::uint64_t>(i), epoch + i), {}, seconds, most);
  return out;
}

std::vector<double> times(const AwaitedFrames& frames) {
  std::vector<double> out;
  for (const dot::AwaitedFrame& f : frames) out.push_back(f.timestamp());
  return out;
}

CameraStep step_ahead(dot::CameraStatus status) {
  CameraStep step;
  step.status = status;
  step.T_cur_prev = SE3d::translation({0, 0, -1});
  return step;
}

TEST(AwaitedFrames, DropsTheOldest) {
  EXPECT_EQ(times(frames(4, 1, 10)), (std::vector<double>{2, 3}));
  EXPECT_EQ(times(frames(4, 10, 10)), (std::vector<double>{0, 1, 2, 3}));
}

TEST(AwaitedFrames, KeepsNoMoreThanItMay) { EXPECT_EQ(times(frames(6, 10, 4)), (std::vector<double>{2, 3, 4, 5})); }

TEST(AwaitedFrames, DropsUpToAFrameWhateverTheClockResolves) {
  // Of a Unix clock a double tells 0.24 us: a sum with 1 ns is the number itself.
  const double unix_time = 1.7e9;
  ASSERT_EQ(unix_time + 1e-9, unix_time);
  AwaitedFrames kept = frames(4, 10, 10, unix_time);
  kept.drop_through(std::next(kept.begin()));
  EXPECT_EQ(times(kept), (std::vector<double>{unix_time + 2, unix_time + 3}));
  kept.drop_through(std::next(kept.begin()));
  EXPECT_TRUE(kept.empty());
}

TEST(AwaitedFrames, FindsTheNewestOfAnId) {
  AwaitedFrames kept = frames(3, 10, 10);
  kept.add(frame(1, 3), {}, 10, 10);
  EXPECT_EQ(kept.find(1)->timestamp(), 3);
  EXPECT_EQ(kept.find(2)->timestamp(), 2);
  EXPECT_EQ(kept.find(4), kept.end());
}

TEST(AwaitedFrames, ComposesTheCamerasMotion) {
  AwaitedFrames kept;
  for (int i = 0; i < 3; ++i) {
    kept.advance(step_ahead(i == 1 ? dot::CameraStatus::Lost : dot::CameraStatus::Tracked));
    kept.add(frame(static_cast<std::uint64_t>(i), i), {}, 10, 10);
  }
  EXPECT_EQ(kept.find(0)->since.T_now_ref.t.z(), -2);
  EXPECT_EQ(kept.find(0)->since.intervals, 2);
  EXPECT_FALSE(kept.find(0)->since_known) << "one of the steps since was a guess";
  EXPECT_EQ(kept.find(1)->since.T_now_ref.t.z(), -1);
  EXPECT_TRUE(kept.find(1)->since_known);
  EXPECT_EQ(kept.find(2)->since.intervals, 0);
}

TEST(AwaitedFrames, LetGoOfTheFramesThatTheyDrop) {
  AwaitedFrames kept = frames(2, 10, 10);
  const dot::FramePtr first = kept.begin()->frame;
  EXPECT_EQ(first.use_count(), 2);
  kept.drop_through(kept.begin());
  EXPECT_EQ(first.use_count(), 1);
}

TEST(AwaitedFrames, AreMovedByRevisedSteps) {
  const auto step_by = [](double metres) {
    CameraStep step = step_ahead(dot::CameraStatus::Tracked);
    step.T_cur_prev = SE3d::translation({0, 0, metres});
    step.covariance.setIdentity();
    return step;
  };
  AwaitedFrames kept;
  for (std::uint64_t i = 0; i < 3; ++i) {
    const CameraStep step = step_by(1);
    kept.advance(step);
    kept.add(frame(10 + i, static_cast<double>(i)), step, 10, 10);
  }
  CameraStep right = step_by(-2);
  right.covariance *= 0.25;
  kept.revise({{11, 1, right}});
  const auto ahead = [&](std::uint64_t id) { return kept.find(id)->since.T_now_ref.t.z(); };
  EXPECT_DOUBLE_EQ(ahead(10), -1);
  EXPECT_DOUBLE_EQ(ahead(11), 1);
  EXPECT_DOUBLE_EQ(ahead(12), 0);
  EXPECT_DOUBLE_EQ(kept.find(10)->since.covariance(2, 2), 1.25);
  EXPECT_DOUBLE_EQ(kept.find(11)->camera.T_cur_prev.t.z(), -2);
}

}  // namespace
