// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/threads/threads.hpp"

#include <atomic>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core/utility.hpp>

#include "dot/tracker.hpp"
#include "support/film.hpp"
#include "support/host_pool.hpp"

namespace {

using dot::ObjectResult;
using dot::Result;
using dot::Threads;
using dot::Tracker;
using namespace dot::test;

TEST(Threads, EachPieceIsDoneOnceByAWorkerThatDoesNothingElse) {
  for (const bool host : {false, true})
    for (const int count : {1, 2, 5})
      for (const int pieces : {0, 1, 2, 37}) {
        SCOPED_TRACE(std::to_string(count) + " threads, " + std::to_string(pieces) + " pieces");
        Threads threads;
        threads.count = count;
        if (host) threads.pool = host_pool;
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(pieces)), busy(5);
        std::atomic<int> wrong{0};
        threads.run(pieces, [&](int worker, int i) {
          if (worker < 0 || worker >= count || busy[static_cast<std::size_t>(worker)]++ != 0) ++wrong;
          ++done[static_cast<std::size_t>(i)];
          std::this_thread::yield();
          --busy[static_cast<std::size_t>(worker)];
        });
        EXPECT_EQ(wrong, 0);
        for (const auto& n : done) EXPECT_EQ(n, 1);
      }
}

TEST(Threads, BandsAreAllRowsOnce) {
  for (const int rows : {0, 1, 7, 8, 93}) {
    Threads threads;
    threads.count = 3, threads.pool = host_pool;
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(rows));
    threads.run_bands(rows, [&](int worker, int begin, int end) {
      EXPECT_LT(worker, 3);
      for (int row = begin; row < end; ++row) ++done[static_cast<std::size_t>(row)];
    });
    for (const auto& n : done) EXPECT_EQ(n, 1) << rows << " rows";
  }
}

// Few pools of a host hand on what a job throws.
TEST(Threads, AnExceptionOfAPieceIsThrownWhateverThePoolDoesWithIt) {
  for (const bool host : {false, true}) {
    Threads threads;
    threads.count = 3;
    if (host) {
      threads.pool = [](int count, const std::function<void(int)>& job) {
        host_pool(count, [&job](int i) {
          try {
            job(i);
          } catch (...) {
          }
        });
      };
    }
    std::atomic<int> begun{0};
    const auto work = [&](int, int i) {
      ++begun;
      if (i == 3) throw std::bad_alloc();
    };
    EXPECT_THROW(threads.run(100000, work), std::bad_alloc);
    EXPECT_LT(begun, 100000) << "pieces begin after one has failed";
  }
}

TEST(Threads, APoolThatRunsNothingIsNoticed) {
  Threads threads;
  threads.count = 2;
  threads.pool = [](int, const std::function<void(int)>&) {};
  EXPECT_THROW(threads.run(5, [](int, int) {}), std::runtime_error);
  EXPECT_NO_THROW(threads.run(1, [](int, int) {}));
}

TEST(Threads, OneRunsInTheCallersThreadAndInOrder) {
  Threads threads;
  threads.pool = [](int, const std::function<void(int)>&) { throw std::logic_error("asked for threads"); };
  std::vector<int> order;
  const auto caller = std::this_thread::get_id();
  threads.run(4, [&](int worker, int i) {
    EXPECT_EQ(worker, 0);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Rounds, WhatTouchesComesInOrder) {
  // On a line, each thing touches what is at most 1 away.
  const std::vector<double> place{0, 5, 0.5, 1.2, 5.5, 9, 2.1};
  std::vector<int> rounds;
  const int count = dot::rounds_of(
      place.size(), [&](std::size_t a, std::size_t b) { return std::abs(place[a] - place[b]) <= 1; }, rounds);
  EXPECT_EQ(rounds, (std::vector<int>{0, 0, 1, 2, 1, 0, 3}));
  EXPECT_EQ(count, 4);
  EXPECT_EQ(dot::rounds_of(
                0, [](std::size_t, std::size_t) { return true; }, rounds),
            0);
}

/// All that a result says, as text.
std::string text(const Result& result) {
  std::string s;
  const auto add = [&s](const auto& values) {
    s.append(reinterpret_cast<const char*>(values.data()), sizeof(values[0]) * values.size());
  };
  add(result.camera.T_cur_prev), add(result.camera.covariance);
  for (const ObjectResult& o : result.objects) {
    s += std::to_string(o.id) + " " + to_string(o.state) + " " + to_string(o.reason) + " " +
         std::to_string(o.n_inliers) + " " + std::to_string(o.area) + "\n";
    add(o.T_o), add(o.covariance), add(o.velocity), add(o.velocity_covariance), add(o.fused_velocity);
    add(std::vector<double>{o.p_moving, o.phi, o.entropy, o.disparity_px, o.range});
  }
  for (int y = 0; y < result.ids.height; ++y) {
    s.append(reinterpret_cast<const char*>(result.ids.row(y)), sizeof(std::uint32_t) * result.ids.width);
    s.append(reinterpret_cast<const char*>(result.labels.row(y)), static_cast<std::size_t>(result.labels.width));
  }
  return s;
}

// A street with a crossing, cars that hide one another, some that come and go, masks in two of three frames.
TEST(Threads, HowManyDoesNotShowInTheResult) {
  Film<> film;
  film.camera_path = straight({0, 0, 0}, {0.2, 0, 1});
  film.degradation.noise = 2;
  film.add(1, straight({-2.8, 1.3, 8}));
  film.add(2, straight({2.9, 1.3, 7}));
  film.add(3, straight({-3.5, 1.3, 6}, {4, 0, 0}));
  film.add(4, straight({3.5, 1.3, 9.5}, {-3, 0, 0}));
  film.add(5, straight({-0.5, 1.3, 10.5}));
  film.edit = [](int i, dot::Frame& frame) {
    if (i % 3 == 2) frame.masks.reset();
  };
  const int before = cv::getNumThreads();
  std::vector<Tracker> trackers;
  const std::vector<int> counts{1, 2, 4, 3};
  for (const int count : counts) {
    dot::Options options;
    options.depth_noise.source = dot::DepthSource::Stereo;
    options.threads = count;
    trackers.emplace_back(small_camera(), options);
  }
  trackers.back().set_pool(host_pool);
  int objects = 0;
  for (int i = 0; i < 14; ++i) {
    const dot::Frame& frame = film.advance();
    const Result& one = trackers[0].track(frame);
    const std::string expected = text(one);
    objects = std::max(objects, static_cast<int>(one.objects.size));
    for (std::size_t k = 1; k < trackers.size(); ++k)
      EXPECT_TRUE(text(trackers[k].track(frame)) == expected) << "frame " << i << ", " << counts[k] << " threads";
  }
  EXPECT_GE(objects, 4);
  EXPECT_EQ(cv::getNumThreads(), before);
}

TEST(Threads, NoneAndThousandsAreRefused) {
  for (const int count : {0, -1, 257, 1000000}) {
    dot::Options options;
    options.threads = count;
    try {
      Tracker tracker(small_camera(), options);
      FAIL() << count << " accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("options.threads"), std::string::npos) << error.what();
    }
  }
}

// What a host's pool throws comes out of `track`, which goes on with the next frame once the pool does.
TEST(Threads, APoolThatFailsLeavesTheTrackerUsable) {
  Film<> film;
  film.add(3, straight({-2, 1.3, 7}, {3, 0, 0}));
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  options.threads = 2;
  Tracker tracker(small_camera(), options);
  film.next(tracker);
  tracker.set_pool([](int, const std::function<void(int)>&) { throw std::runtime_error("no threads left"); });
  EXPECT_THROW(film.next(tracker), std::runtime_error);
  tracker.set_pool({});
  const ObjectResult* o = nullptr;
  for (int i = 0; i < 4; ++i) o = object_on(film.next(tracker), film.truth().ids, 3);
  ASSERT_TRUE(o);
  EXPECT_EQ(o->state, dot::State::Moving) << describe(o);
}

}  // namespace
