// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "real_time/simulated_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "real_time/delayed_masks.hpp"
#include "scene.hpp"

namespace real_time::test {
namespace {

/// What is done before each of the frames, 0.1 s apart: "frame@done", with the time in milliseconds.
std::vector<std::string> play_frames(SimulatedNetwork& network, int frames) {
  std::vector<std::string> log;
  for (int i = 0; i < frames; ++i) {
    log.emplace_back();
    for (const LateSegmentation& late : network.take(0.1 * i)) {
      log.back() += (log.back().empty() ? "" : " ") + std::to_string(late.frame) + "@" +
                    std::to_string(std::lround(1000 * late.done));
      EXPECT_NEAR(late.captured, 0.1 * late.frame, 1e-12);
    }
    network.offer(wall_ptr(i));
  }
  return log;
}

FrameSegmenter own_masks() { return recorded_masks(0).segment; }

TEST(SimulatedNetwork, FasterThanTheFramesSegmentsAll) {
  SimulatedNetwork network(0.02, own_masks());
  EXPECT_EQ(play_frames(network, 4), (std::vector<std::string>{"", "0@20", "1@120", "2@220"}));
  EXPECT_EQ(network.skipped(), 0);
}

TEST(SimulatedNetwork, ExactlyAsFastAsTheFramesSegmentsAll) {
  SimulatedNetwork network(0.1, own_masks());
  EXPECT_EQ(play_frames(network, 4), (std::vector<std::string>{"", "0@100", "1@200", "2@300"}));
  EXPECT_EQ(network.skipped(), 0);
}

TEST(SimulatedNetwork, SlowerTakesTheNewestFrameWhenItIsReady) {
  // 0 to 250: frame 0. Then frames 1 and 2 have come: 250 to 500 frame 2. Then 3 and 4: 500 to 750 frame 4, for frame 5
  // comes when that has begun. Then 5, 6 and 7: frame 7. Frame 8 waits.
  SimulatedNetwork network(0.25, own_masks());
  EXPECT_EQ(play_frames(network, 9), (std::vector<std::string>{"", "", "", "0@250", "", "2@500", "", "", "4@750"}));
  EXPECT_EQ(network.skipped(), 4);
}

TEST(SimulatedNetwork, WithoutDelayTheMasksComeBeforeTheNextFrame) {
  SimulatedNetwork network(0, own_masks());
  EXPECT_EQ(play_frames(network, 3), (std::vector<std::string>{"", "0@0", "1@100"}));
}

TEST(DelayedMasks, KeepAccount) {
  dot::Tracker tracker(camera());
  DelayedMasks delayed(recorded_masks(0.25), tracker);
  for (int i = 0; i < 9; ++i) {
    const FramePtr kept = wall_ptr(i);
    const dot::Frame frame = delayed.next(kept);
    EXPECT_FALSE(frame.masks);
    const dot::Result& result = tracker.track(frame);
    EXPECT_EQ(result.objects.end() - result.objects.begin(), i < 3 ? 0 : 1)
        << i;  // 250 ms after frame 0 is before frame 3
  }
  const Report report = delayed.report();
  EXPECT_EQ(report.frames, 9);
  EXPECT_EQ(report.offered, 9);
  EXPECT_EQ(report.skipped, 4);
  EXPECT_EQ(report.refused, 0);
  EXPECT_EQ(report.unfinished(), 2);
  ASSERT_EQ(report.mask_latency.size(), 3U);
  EXPECT_NEAR(report.mask_latency[0], 0.25, 1e-9);
  EXPECT_NEAR(report.mask_latency[1], 0.3, 1e-9);
  EXPECT_NEAR(report.mask_latency[2], 0.35, 1e-9);
}

TEST(DelayedMasks, TooLateIsCountedNotAnError) {
  dot::Tracker tracker(camera());
  DelayedMasks delayed(recorded_masks(1.25), tracker);  // Options::mask.late_seconds is 1
  for (int i = 0; i < 15; ++i) tracker.track(delayed.next(wall_ptr(i)));
  EXPECT_EQ(delayed.report().refused, 1);
  EXPECT_TRUE(delayed.report().mask_latency.empty());
}

TEST(DelayedMasks, FramesWithoutMasksAreNotSegmented) {
  dot::Tracker tracker(camera());
  DelayedMasks delayed(recorded_masks(0.02), tracker);
  for (int i = 0; i < 6; ++i) {
    runner::SequenceFrame frame = wall(i);
    if (i % 3 != 0) frame.ids.release();
    tracker.track(delayed.next(std::make_shared<const runner::SequenceFrame>(frame)));
  }
  EXPECT_EQ(delayed.report().offered, 2);
}

TEST(LateMasksFeed, MasksThatAreWrongAreAnError) {
  dot::Tracker tracker(camera());
  const runner::SequenceFrame kept = wall(0);
  dot::Frame frame = kept.frame();
  frame.masks.reset();
  tracker.track(frame);
  LateMasksFeed feed(tracker);
  LateSegmentation late;
  late.segmentation.ids = cv::Mat(height, width + 1, CV_8UC1, cv::Scalar(0));
  EXPECT_THROW(feed.submit(late), std::invalid_argument);
  EXPECT_EQ(feed.refused(), 0);
}

}  // namespace
}  // namespace real_time::test
