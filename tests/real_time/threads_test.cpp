// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "real_time/inbox.hpp"
#include "real_time/network_thread.hpp"
#include "real_time/real_time.hpp"
#include "scene.hpp"

// The threads of a run in real time. Nothing here depends on how fast they are.

namespace real_time::test {
namespace {

runner::Segmentation own_masks(const runner::SequenceFrame& frame) { return {frame.ids.clone(), frame.instances}; }

LateSegmentation late(int frame) { return {frame, 0, 0, {}}; }

int number_of(const std::optional<Inbox::Item>& item) {
  if (!item) return -1;
  if (const auto* arrival = std::get_if<Arrival>(&*item)) return arrival->frame->number;
  return 1000 + std::get<LateSegmentation>(*item).frame;
}

TEST(Inbox, MasksComeFirstAndOnlyTheNewestFrame) {
  Inbox inbox;
  inbox.put(Arrival{wall_ptr(1), 0});
  inbox.put(Arrival{wall_ptr(2), 0});
  inbox.put(late(0));
  inbox.put(late(1));
  inbox.close();
  EXPECT_EQ(number_of(inbox.take()), 1000);
  EXPECT_EQ(number_of(inbox.take()), 1001);
  EXPECT_EQ(number_of(inbox.take()), 2);
  EXPECT_EQ(number_of(inbox.take()), -1);
  EXPECT_EQ(inbox.dropped(), 1);
}

TEST(Inbox, WaitsForWhatComes) {
  Inbox inbox;
  std::thread other([&] { inbox.put(Arrival{wall_ptr(5), 0}); });
  EXPECT_EQ(number_of(inbox.take()), 5);
  other.join();
  std::thread closer([&] { inbox.close(); });
  EXPECT_EQ(number_of(inbox.take()), -1);
  closer.join();
}

TEST(Inbox, ThrowsTheFirstFailure) {
  Inbox inbox;
  inbox.put(Arrival{wall_ptr(1), 0});
  inbox.fail(std::make_exception_ptr(std::runtime_error("first")));
  inbox.fail(std::make_exception_ptr(std::runtime_error("second")));
  try {
    inbox.take();
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "first");
  }
}

TEST(NetworkThread, WorksOnTheNewestFrame) {
  FakeClock clock;
  Inbox inbox;
  std::promise<void> begun, go_on;
  const std::shared_future<void> may_go_on = go_on.get_future();
  bool first = true;  // of the network's thread alone
  NetworkThread network(
      [&](const runner::SequenceFrame& frame) {
        if (first) {
          first = false;
          begun.set_value();
          may_go_on.wait();
        }
        return own_masks(frame);
      },
      0.5, clock, inbox);
  network.offer({wall_ptr(0), 1});
  begun.get_future().wait();
  for (int i = 1; i <= 3; ++i) network.offer({wall_ptr(i), 1});
  go_on.set_value();
  EXPECT_EQ(number_of(inbox.take()), 1000);
  const auto item = inbox.take();
  EXPECT_EQ(number_of(item), 1003);
  EXPECT_EQ(network.skipped(), 2);
  EXPECT_EQ(std::get<LateSegmentation>(*item).captured, 1);
  EXPECT_GE(std::get<LateSegmentation>(*item).done, 101);  // the clock began at 100; twice half a second
}

TEST(NetworkThread, ItsFailureIsTheInboxs) {
  FakeClock clock;
  Inbox inbox;
  NetworkThread network(
      [](const runner::SequenceFrame&) -> runner::Segmentation { throw std::runtime_error("broken"); }, 0, clock,
      inbox);
  network.offer({wall_ptr(0), 1});
  EXPECT_THROW(inbox.take(), std::runtime_error);
  network.offer({wall_ptr(1), 1});  // nobody is there any more
}

TEST(NetworkThread, EndsWithoutAFrame) {
  FakeClock clock;
  Inbox inbox;
  const NetworkThread network(own_masks, 0, clock, inbox);
}

/// Frames of the wall as from a camera.
struct Play {
  Source source{wall, {}, {own_masks, [](const runner::SequenceFrame&) { return true; }, 0.05}};
  FakeClock clock;
  std::atomic<bool> stop{false};
  dot::Tracker tracker{camera()};
  std::vector<int> numbers;

  explicit Play(int frames) {
    for (int i = 0; i < frames; ++i) source.times.push_back(0.1 * i);
  }
  Report run() {
    return play(source, clock, stop, tracker,
                [this](const runner::SequenceFrame& frame, const dot::Result& result, double) {
                  numbers.push_back(frame.number);
                  EXPECT_EQ(result.frame_id, static_cast<std::uint64_t>(frame.number));
                  EXPECT_EQ(result.labels.width, width);
                });
  }
};

TEST(RealTime, KeepsAccountOfFramesAndMasks) {
  Play play(40);
  const Report report = play.run();
  EXPECT_EQ(report.frames, 40);
  EXPECT_GE(report.tracked, 1);
  EXPECT_EQ(static_cast<std::size_t>(report.tracked), play.numbers.size());
  EXPECT_EQ(report.frame_latency.size(), play.numbers.size());
  EXPECT_TRUE(std::is_sorted(play.numbers.begin(), play.numbers.end()));
  EXPECT_EQ(play.numbers.back(), 39);  // the last frame is never replaced
  EXPECT_EQ(report.offered, report.tracked);
  EXPECT_GE(report.unfinished(), 0);
  EXPECT_FALSE(play.stop);
}

TEST(RealTime, AFrameIsTrackedWithoutItsMasks) {
  Play one(1);
  int calls = 0;
  play(one.source, one.clock, one.stop, one.tracker,
       [&](const runner::SequenceFrame& frame, const dot::Result& result, double) {
         ++calls;
         EXPECT_FALSE(frame.ids.empty());
         EXPECT_TRUE(result.objects.empty());
       });
  EXPECT_EQ(calls, 1);
}

TEST(RealTime, WithoutFrames) {
  Play play(0);
  EXPECT_EQ(play.run().frames, 0);
}

TEST(RealTime, AStopInTheMiddleEndsTheRun) {
  Play play(1000000);
  play.source.read = [&](int i) {
    if (i == 3) play.stop = true;
    return wall(i);
  };
  const Report report = play.run();
  EXPECT_LE(report.frames, 4);
  EXPECT_TRUE(play.stop);
}

TEST(RealTime, FailuresOfAnyThreadEndTheRun) {
  Play network(1000000);
  network.source.network.segment = [](const runner::SequenceFrame& frame) -> runner::Segmentation {
    throw std::runtime_error("network " + std::to_string(frame.number));
  };
  EXPECT_THROW(network.run(), std::runtime_error);

  Play reader(1000000);
  reader.source.read = [](int i) {
    if (i == 4) throw std::runtime_error("reader");
    return wall(i);
  };
  EXPECT_THROW(reader.run(), std::runtime_error);

  Play consumer(1000000);
  EXPECT_THROW(play(consumer.source, consumer.clock, consumer.stop, consumer.tracker,
                    [](const runner::SequenceFrame&, const dot::Result&, double) { throw std::runtime_error("disk"); }),
               std::runtime_error);

  Play masks(1000000);
  masks.source.network.segment = [](const runner::SequenceFrame&) {
    return runner::Segmentation{cv::Mat(1, 1, CV_8UC1, cv::Scalar(0)), {}};
  };
  EXPECT_THROW(masks.run(), std::invalid_argument);
}

TEST(RealTime, AFailureOfTheNetworkAfterTheLastFrameIsAnErrorAsWell) {
  Play play(2);
  std::promise<void> begun;  // the network, with frame 0
  const auto reader = std::make_shared<int>();
  play.source.read = [reader, has_begun = begun.get_future().share()](int i) {
    if (i == 1) has_begun.wait();
    return wall(i);
  };
  play.source.network.segment = [&](const runner::SequenceFrame&) -> runner::Segmentation {
    begun.set_value();
    // Until the camera's thread is gone, with its copy of the reader: then nobody takes from the inbox any more.
    while (reader.use_count() > 2) std::this_thread::yield();
    throw std::runtime_error("late");
  };
  EXPECT_THROW(play.run(), std::runtime_error);
}

TEST(WriterThread, ConsumesAllInOrderWithTheirOwnPixels) {
  dot::Tracker tracker(camera());
  std::vector<int> areas;
  std::promise<void> all_put;  // the tracker has overwritten its buffers by then
  const std::shared_future<void> are_put = all_put.get_future();
  WriterThread writer([&](const runner::SequenceFrame& frame, const dot::Result& result, double ms) {
    are_put.wait();
    EXPECT_EQ(ms, frame.number);
    int area = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) area += result.ids(x, y) != 0 && result.labels(x, y) != 0;
    areas.push_back(area);
    EXPECT_EQ(result.objects.empty(), area == 0);
  });
  for (int i = 0; i < 5; ++i) {
    runner::SequenceFrame frame = wall(i);
    if (i == 0) frame.ids = 0;  // the network ran and found nothing
    const FramePtr kept = std::make_shared<const runner::SequenceFrame>(frame);
    writer.put(kept, tracker.track(kept->frame()), i);
  }
  all_put.set_value();
  writer.finish();
  ASSERT_EQ(areas.size(), 5U);
  EXPECT_EQ(areas[0], 0);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(areas[i], 300) << i;
}

}  // namespace
}  // namespace real_time::test
