// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "dot/dot.h"
#include "dot/tracker.hpp"
#include "fuzz/scene.hpp"
#include "fuzz/views.hpp"
#include "memory/allocation_counter.hpp"

/// @file
/// The C interface where memory is short: each allocation of a tracker's life fails in turn, once or with all after it.

namespace {

using dot::test::AllocationCounter;
using dot::test::MemoryShortage;

constexpr int kWidth = 64, kHeight = 48;
constexpr double kFocal = 65;
constexpr int kFrames = 10;

/// The frames, rendered once.
struct Film {
  fuzz::Arena arena;
  std::array<dot_frame, kFrames> frames;
  std::array<const dot_masks*, kFrames> masks;

  Film() {
    fuzz::Scene scene(fuzz::Input(nullptr, 0), kFocal, kWidth, kHeight);
    scene.plates[1].velocity_x = 4;
    for (std::size_t i = 0; i < kFrames; ++i) {
      scene.advance(0.1);
      fuzz::Picture picture = scene.render();
      // No sensor has exactly one depth on all of a wall. What has counts as the end of the depth in the first frames.
      for (std::size_t k = 0; k < picture.depth.size(); ++k) picture.depth[k] *= 1 + 1e-5f * static_cast<float>(k % 7);
      frames[i] = DOT_FRAME_INIT;
      frames[i].image = fuzz::grey_or_colour(arena, picture, DOT_FORMAT_BGR8, 0, -1, 0);
      frames[i].depth = fuzz::depth_image(arena, picture, false, 0, -1, 0);
      for (std::uint8_t& id : picture.ids) id = id == 2 ? 0 : id;  // the one that drives is to be discovered
      dot_masks all = DOT_MASKS_INIT;
      all.ids = fuzz::make_image(arena, DOT_FORMAT_ID8, kWidth, kHeight, 0, -1, 0,
                                 [&](std::size_t at, unsigned char* out) { *out = picture.ids[at]; });
      masks[i] = arena.place(all);
    }
  }
};

/// A tracker that is told of frames, and whether memory has run out on the way.
class Life {
 public:
  Life(const Film& film, int threads, MemoryShortage& shortage) : film_(film), shortage_(shortage) {
    dot_camera camera = DOT_CAMERA_INIT;
    camera.width = kWidth;
    camera.height = kHeight;
    camera.fx = camera.fy = kFocal;
    camera.cx = 0.5 * kWidth;
    camera.cy = 0.5 * kHeight;
    camera.baseline = 0.5;
    dot_options options = DOT_OPTIONS_INIT;
    options.background_points = 300;
    options.object_points = 80;
    options.depth_source = DOT_DEPTH_STEREO;
    // Short searches: they take time and no memory.
    const dot_setting settings[] = {{"threads", static_cast<double>(threads)},
                                    {"discover_unknown", 1},
                                    {"camera.search_speed", 1},
                                    {"camera.search_turn", 0.1},
                                    {"object.search_speed", 8},
                                    {"align.max_iterations", 4}};
    options.settings = settings;
    options.setting_count = 6;
    const dot_status status = dot_create(&camera, &options, &tracker_);
    check(status, dot_create_error());
    expect((tracker_ != nullptr) == (status == DOT_OK), "the tracker is there if it was made", status, "");
  }
  ~Life() { dot_destroy(tracker_); }
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;

  /// All of it, up to the first call that fails. @return whether none did.
  bool live() {
    return tracker_ != nullptr && track(0, true) && track(1, true) && track(2, false) && track(3, false) && submit(2) &&
           track(4, false) && track(5, false) && track(6, false) && look() && exclude() && track(7, true) && reset() &&
           track(8, true) && track(9, false);
  }

  /// What a host may go on to call while memory stays short: each succeeds or tells why not.
  void go_on() {
    if (tracker_ == nullptr) return;
    track(5, true);
    submit(5);
    exclude();
    std::uint32_t count = 0;
    const dot_status status = dot_object_count(tracker_, &count);
    if (status != DOT_NO_RESULT) check(status);
    reset();
  }

  bool discovered() const { return discovered_; }
  const char* complaint() const { return complaint_; }

  /// With memory back, the tracker is as good as new.
  void expect_usable() {
    if (tracker_ == nullptr) return;
    EXPECT_TRUE(track(6, true) && track(7, true)) << dot_last_error(tracker_);
    std::uint32_t count = 0;
    EXPECT_EQ(dot_object_count(tracker_, &count), DOT_OK);
    EXPECT_GE(count, 1u);
  }

 private:
  /// @return whether the call succeeded. Memory is the only thing that may have failed it.
  bool check(dot_status status, const char* text) {
    if (status == DOT_OK) return true;
    expect(status == DOT_OUT_OF_MEMORY && shortage_.reached(), "memory is all that may be wanting", status, text);
    expect(std::strcmp(text, "out of memory") == 0, "the text says so", status, text);
    return false;
  }
  bool check(dot_status status) { return check(status, dot_last_error(tracker_)); }

  bool track(std::size_t index, bool with_masks) {
    dot_frame frame = film_.frames[index];
    frame.id = index;
    frame.timestamp = time_ += 0.1;
    frame.masks = with_masks ? film_.masks[index] : nullptr;
    const bool in_two_steps = index % 3 == 2;
    const bool done = in_two_steps ? check(dot_label(tracker_, &frame)) && check(dot_prepare(tracker_))
                                   : check(dot_track(tracker_, &frame));
    std::uint32_t count = 0;
    const dot_status status = dot_object_count(tracker_, &count);
    if (status != (done ? DOT_OK : DOT_NO_RESULT)) check(status);
    return done;
  }
  /// Late masks, which a tracker that was reset on the way does not know.
  bool submit(std::size_t index) {
    const dot_status status = dot_submit_masks(tracker_, index, film_.masks[index]);
    return (status == DOT_INVALID_ARGUMENT && shortage_.reached()) || check(status);
  }
  bool exclude() {
    std::array<std::uint8_t, kWidth * kHeight> mask;
    const dot_status status = dot_exclusion_mask(tracker_, nullptr, mask.data(), kWidth, kHeight, kWidth);
    return (status == DOT_NO_RESULT && shortage_.reached()) || check(status);
  }
  /// Whether one of the objects is there by its motion alone.
  bool look() {
    dot_object object = DOT_OBJECT_INIT;
    std::uint32_t count = 0;
    dot_object_count(tracker_, &count);
    for (std::uint32_t i = 0; i < count && dot_get_object(tracker_, i, &object) == DOT_OK; ++i)
      discovered_ = discovered_ || (object.flags & DOT_OBJECT_DISCOVERED) != 0;
    return true;
  }
  /// Takes no memory and must not need any.
  bool reset() {
    const dot_status status = dot_reset(tracker_);
    expect(status == DOT_OK, "reset always succeeds", status, dot_last_error(tracker_));
    return true;
  }

  /// Googletest needs memory to fail: the first failure is kept for later.
  void expect(bool holds, const char* what, dot_status status, const char* text) {
    if (!holds && complaint_[0] == '\0')
      std::snprintf(complaint_, sizeof complaint_, "%s: %d '%s'", what, status, text);
  }

  char complaint_[300] = "";
  const Film& film_;
  MemoryShortage& shortage_;
  dot_tracker* tracker_ = nullptr;
  double time_ = 0;
  bool discovered_ = false;
};

/// @param step from one allocation that fails to the next that does
void try_all(int threads, MemoryShortage::Duration duration, long step) {
  const Film film;
  {  // what OpenCV and the C++ library allocate once for the process
    MemoryShortage none(1L << 40, MemoryShortage::Once);
    Life life(film, threads, none);
    ASSERT_TRUE(life.live());
    ASSERT_TRUE(life.discovered()) << "the film takes little of the memory that there is to take";
  }
  bool reached = true;
  long k = 0;
  for (; reached && !testing::Test::HasFailure(); k += step) {
    SCOPED_TRACE("allocation " + std::to_string(k) + " of a tracker's life fails");
    MemoryShortage shortage(k, duration);
    Life life(film, threads, shortage);
    life.live();
    reached = shortage.reached();
    if (reached && duration == MemoryShortage::Lasting) life.go_on();
    shortage.end();
    life.expect_usable();
    EXPECT_STREQ(life.complaint(), "");
  }
  EXPECT_GT(k, 200) << "the film takes little of the memory that there is to take";
}

TEST(MemoryShortage, HasEachKindOfAllocationFail) {
  const MemoryShortage shortage(0, MemoryShortage::Lasting);
  std::vector<int> numbers;
  EXPECT_THROW(numbers.resize(1000), std::bad_alloc);
  if (AllocationCounter::sees_malloc()) {
    EXPECT_ANY_THROW(cv::Mat(10, 10, CV_8U));
  }
}

TEST(MemoryShortage, HasOneAllocationFail) {
  std::vector<int> first, second, third;
  const MemoryShortage shortage(1, MemoryShortage::Once);
  first.resize(10);
  EXPECT_FALSE(shortage.reached());
  EXPECT_THROW(second.resize(10), std::bad_alloc);
  EXPECT_TRUE(shortage.reached());
  third.resize(10);
}

// Sanitizers make each life ten times as long.
const long every = AllocationCounter::sees_malloc() ? 1 : 29;

TEST(OutOfMemory, OnceInOneThread) { try_all(1, MemoryShortage::Once, every); }
TEST(OutOfMemory, LastingInOneThread) { try_all(1, MemoryShortage::Lasting, every); }
TEST(OutOfMemory, OnceInFourThreads) { try_all(4, MemoryShortage::Once, every); }
TEST(OutOfMemory, LastingInFourThreads) { try_all(4, MemoryShortage::Lasting, every); }

// Each call that fails for a lack of memory leaves the tracker as after a reset: its clock may start again.
TEST(OutOfMemory, ResetsATracker) {
  std::vector<std::uint8_t> grey(kWidth * kHeight), ids(kWidth * kHeight);
  std::vector<float> depth(kWidth * kHeight, 5.f);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    grey[i] = static_cast<std::uint8_t>(i * 2654435761u >> 24);
    ids[i] = i % kWidth > 20 && i % kWidth < 40;
  }
  const auto frame_at = [&](double timestamp) {
    dot::Frame frame;
    frame.timestamp = timestamp;
    frame.image = {grey.data(), kWidth, kHeight, kWidth, dot::PixelFormat::Grey8};
    frame.depth = {depth.data(), kWidth, kHeight, 4 * kWidth, dot::PixelFormat::DepthF32};
    return frame;
  };
  bool reached = true;
  int failed = 0;
  for (long k = 0; reached; k += every) {
    dot::Tracker tracker({kFocal, kFocal, 0.5 * kWidth, 0.5 * kHeight, kWidth, kHeight, 0}, {});
    tracker.track(frame_at(1));
    dot::Frame next = frame_at(1.1);
    next.masks = dot::Masks{{ids.data(), kWidth, kHeight, kWidth, dot::PixelFormat::Id8}, {}};
    MemoryShortage shortage(k, MemoryShortage::Once);
    bool done = true;
    try {
      tracker.track(next);
    } catch (const std::bad_alloc&) {
      done = false;
    }
    reached = shortage.reached();
    shortage.end();
    failed += !done;
    if (!done) {
      EXPECT_NO_THROW(tracker.track(frame_at(0))) << "after allocation " << k;
    }
  }
  EXPECT_GT(failed, 5);
}

}  // namespace
