// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <opencv2/core.hpp>
#include <set>
#include <vector>

#include "dot/tracker.hpp"
#include "memory/allocation_counter.hpp"
#include "support/film.hpp"
#include "support/random.hpp"

/// @file
/// `track` takes memory in the first frames only. Each film repeats itself, so that what was large enough once is large
/// enough for ever.

namespace {

using dot::Reason;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Tracker;
using dot::Vector3;
using dot::test::AllocationCounter;
using dot::test::describe;
using dot::test::Film;
using dot::test::object_on;
using dot::test::Path;
using dot::test::small_camera;

constexpr int kPeriod = 30;  ///< frames, after which a film begins anew
constexpr int kWarmUp = 2 * kPeriod;
constexpr std::uint32_t parked = 1, mover = 2, behind = 3, visitor = 4;

/// To and fro about a place.
Path swaying(const Vector3<double>& about, const Vector3<double>& reach, double phase = 0) {
  return [=](double t) {
    const double angle = 6.283185307179586 * t / (0.1 * kPeriod) + phase;
    return SE3d::translation(Vector3<double>(about + reach * std::sin(angle)));
  };
}

/// A camera that sways before two parked cars, one half behind the other, and one that drives to and fro past them.
Film<> crossing() {
  Film<> film;
  film.camera_path = swaying(Vector3<double>::Zero(), {0.1, 0, 0.3});
  film.add(parked, dot::test::straight({-1.2, 1.3, 7}));
  film.add(behind, dot::test::straight({-0.2, 1.3, 9.5}));
  film.add(mover, swaying({1.6, 1.3, 6}, {0.9, 0, 0}, 1));
  return film;
}

Tracker make_tracker() {
  cv::setNumThreads(1);
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  return Tracker(small_camera(), options);
}

/// The next frame's result. @param count grows by the allocations within `track`.
const Result& next(Film<>& film, Tracker& tracker, long& count) {
  const dot::Frame& frame = film.advance();
  const AllocationCounter counter;
  const Result& result = tracker.track(frame);
  count += counter.count();
  return result;
}

/// Allocations within `track` of one frame after another.
long allocations(Film<>& film, Tracker& tracker, int frames) {
  long count = 0;
  for (int i = 0; i < frames; ++i) next(film, tracker, count);
  return count;
}

const dot::ObjectResult* seen_on(Film<>& film, Tracker& tracker, std::uint32_t body) {
  return object_on(film.next(tracker), film.truth().ids, body);
}

TEST(AllocationCounter, SeesEveryWayToTakeMemory) {
  struct alignas(64) Wide {
    char bytes[64];
  };
  const auto count = [](auto&& allocate) {
    const AllocationCounter counter;
    allocate();
    return counter.count();
  };
  std::vector<int> kept;
  EXPECT_EQ(count([] {}), 0);
  EXPECT_EQ(count([&] { kept.resize(1000); }), 1);
  EXPECT_EQ(count([&] { kept.resize(500); }), 0);
  if (!AllocationCounter::sees_malloc()) return;
  void* volatile memory = nullptr;  // volatile: compilers may leave out what is only freed again
  EXPECT_EQ(count([&] { memory = std::malloc(10); }), 1);
  EXPECT_EQ(count([&] { memory = std::realloc(memory, 10000); }), 1);
  std::free(memory);
  EXPECT_EQ(count([&] { memory = std::calloc(10, 10); }), 1);
  std::free(memory);
  EXPECT_EQ(count([&] { memory = std::aligned_alloc(64, 64); }), 1);
  std::free(memory);
  EXPECT_EQ(count([&] { memory = new (std::nothrow) char[10]; }), 1);
  delete[] static_cast<char*>(memory);
  EXPECT_EQ(count([&] { memory = new Wide; }), 1);
  delete static_cast<Wide*>(memory);
  EXPECT_GE(count([] { cv::Mat(10, 10, CV_8U); }), 1);
}

TEST(SteadyState, WithMasksInEveryFrame) {
  Film<> film = crossing();
  Tracker tracker = make_tracker();
  allocations(film, tracker, kWarmUp);
  EXPECT_EQ(allocations(film, tracker, kPeriod), 0);

  const Result& result = film.next(tracker);
  EXPECT_EQ(result.objects.size, 3u);
  for (const std::uint32_t body : {parked, behind, mover}) {
    const dot::ObjectResult* object = object_on(result, film.truth().ids, body);
    ASSERT_TRUE(object) << body;
    EXPECT_EQ(object->state, body == mover ? State::Moving : State::Static) << describe(object);
    EXPECT_EQ(object->reason, Reason::None) << describe(object);
  }
}

// What is learnt of the bias is taken from each frame's depth and from all points.
TEST(SteadyState, WithABiasedDepth) {
  Film<> film = crossing();
  film.spoil = [](int, dot::test::Rendering& seen) {
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (float& z = seen.depth(x, y); z > 0) z = 1 / (1 / z + 4e-3f * (static_cast<float>(x) / 32 - 5));
  };
  Tracker tracker = make_tracker();
  allocations(film, tracker, kWarmUp);
  EXPECT_GT(film.next(tracker).disparity_bias_px, 0.1);
  EXPECT_EQ(allocations(film, tracker, kPeriod), 0);
}

// Each frame of a period has other measurements.
TEST(SteadyState, WithSparseDepth) {
  constexpr double share = 0.05;
  Film<> film = crossing();
  film.spoil = [](int i, dot::test::Rendering& seen) {
    dot::test::Random random(static_cast<unsigned>(i % kPeriod));
    for (int y = 0; y < seen.depth.height(); ++y)
      for (int x = 0; x < seen.depth.width(); ++x)
        if (random.uniform() > share) seen.depth(x, y) = 0;
  };
  Tracker tracker = make_tracker();
  allocations(film, tracker, kWarmUp);
  const dot::ObjectResult* object = seen_on(film, tracker, mover);
  ASSERT_TRUE(object);
  EXPECT_GT(object->n_points, 0) << describe(object);
  EXPECT_EQ(allocations(film, tracker, kPeriod), 0);
}

// Outlines are carried on and grow, frames are kept for masks that may come; other formats of image, depth and masks.
TEST(SteadyState, WithMasksInEveryThirdFrame) {
  Film<> film = crossing();
  std::vector<std::uint8_t> colour;
  std::vector<std::uint16_t> millimetres;
  film.edit = [&](int i, dot::Frame& frame) {
    colour.clear();
    millimetres.clear();
    const dot::test::Rendering& seen = film.seen();
    for (int y = 0; y < seen.grey.height(); ++y)
      for (int x = 0; x < seen.grey.width(); ++x) {
        colour.insert(colour.end(), 3, seen.grey(x, y));
        millimetres.push_back(static_cast<std::uint16_t>(1000 * seen.depth(x, y)));
      }
    frame.image = {colour.data(), seen.grey.width(), seen.grey.height(), 3 * seen.grey.width(), dot::PixelFormat::Bgr8};
    frame.depth = {millimetres.data(), seen.grey.width(), seen.grey.height(), 2 * seen.grey.width(),
                   dot::PixelFormat::DepthU16};
    if (i % 3 != 0) frame.masks.reset();
  };
  Tracker tracker = make_tracker();
  allocations(film, tracker, kWarmUp);
  EXPECT_EQ(allocations(film, tracker, kPeriod), 0);

  const dot::ObjectResult* object = seen_on(film, tracker, mover);
  ASSERT_TRUE(object);
  EXPECT_EQ(object->state, State::Moving) << describe(object);
}

// A car comes and goes; what it left serves the next one, which is another track.
TEST(SteadyState, WithObjectsThatComeAndGo) {
  Film<> film = crossing();
  film.add(visitor, [](double t) {
    const double phase = std::fmod(t / 0.1 + 0.5, kPeriod);  // in the middle between frames
    return SE3d::translation(Vector3<double>(phase < 12 ? -1.5 : 100, 0, 5));
  });
  Tracker tracker = make_tracker();
  std::set<std::uint32_t> ids;
  long warm_up = 0, count = 0;
  for (int i = 0; i < 2 * kWarmUp; ++i) {
    const Result& result = next(film, tracker, i < kWarmUp ? warm_up : count);
    if (const dot::ObjectResult* object = object_on(result, film.truth().ids, visitor)) ids.insert(object->id);
  }
  EXPECT_EQ(count, 0);
  EXPECT_EQ(ids.size(), 2 * kWarmUp / kPeriod);
}

// Masks as a list, each an image of its own, and the camera's motion from the host, or where to look for it. Every
// other motion is the inverse.
TEST(SteadyState, WithAllThatAHostMayGive) {
  Film<> film = crossing();
  std::vector<std::vector<std::uint8_t>> masks(3);
  std::vector<dot::Instance> instances(3);
  film.edit = [&](int i, dot::Frame& frame) {
    const dot::Image<std::uint32_t>& ids = film.seen().ids;
    for (std::uint32_t id = 1; id <= 3; ++id) {
      std::vector<std::uint8_t>& mask = masks[id - 1];
      mask.clear();
      for (int y = 0; y < ids.height(); ++y)
        for (int x = 0; x < ids.width(); ++x) mask.push_back(ids(x, y) == id);
      instances[id - 1].id = id;
      instances[id - 1].mask = {mask.data(), ids.width(), ids.height(), ids.width(), dot::PixelFormat::Id8};
    }
    frame.masks->ids = {};
    frame.masks->instances = {instances.data(), instances.size()};
    if (i == 0) return;
    if (i % 2) {
      frame.camera_prior = film.T_c().row_major();
    } else {
      frame.camera_motion.emplace().T_cur_prev = (i % 4 ? film.T_c() : film.T_c().inverse()).row_major();
      for (std::size_t k = 0; k < 6; ++k) frame.camera_motion->covariance[7 * k] = 1e-8;
    }
  };
  Tracker tracker = make_tracker();
  allocations(film, tracker, kWarmUp);
  EXPECT_EQ(allocations(film, tracker, kPeriod), 0);

  const dot::ObjectResult* object = seen_on(film, tracker, mover);
  ASSERT_TRUE(object);
  EXPECT_EQ(object->state, State::Moving) << describe(object);
}

// A clock that runs in other units, or a camera of a million frames a second: what is remembered is bounded all the
// same.
TEST(SteadyState, WithFramesMicrosecondsApart) {
  for (const bool masks : {true, false}) {
    Film<> film = crossing();
    film.epoch = 0;
    film.edit = [masks](int i, dot::Frame& frame) {
      frame.timestamp = 1e-6 * i;
      if (!masks && i > 0) frame.masks.reset();
    };
    Tracker tracker = make_tracker();
    allocations(film, tracker, 6 * kWarmUp);
    EXPECT_EQ(allocations(film, tracker, kPeriod), 0) << "masks " << masks;
  }
}

}  // namespace
