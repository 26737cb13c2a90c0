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
#include "fuzz/scene.hpp"
#include "fuzz/views.hpp"
#include "memory/allocation_counter.hpp"

/// @file
/// The C interface where memory is short: each allocation of a tracker's life fails in turn, once or with all after it.

namespace {

using dot::test::MemoryShortage;

constexpr int kWidth = 96, kHeight = 64;
constexpr int kFrames = 8;

/// The frames, rendered once.
struct Film {
  fuzz::Arena arena;
  std::array<dot_frame, kFrames> frames;
  std::array<const dot_masks*, kFrames> masks;

  Film() {
    const double focal = 95;
    fuzz::Scene scene(fuzz::Input(nullptr, 0), focal, kWidth, kHeight);
    for (std::size_t i = 0; i < kFrames; ++i) {
      scene.advance(0.1);
      fuzz::Picture picture = scene.render();
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
    camera.fx = camera.fy = 95;
    camera.cx = 0.5 * kWidth;
    camera.cy = 0.5 * kHeight;
    camera.baseline = 0.5;
    dot_options options = DOT_OPTIONS_INIT;
    options.background_points = 300;
    options.object_points = 80;
    options.depth_source = DOT_DEPTH_STEREO;
    const dot_setting settings[] = {{"threads", static_cast<double>(threads)}, {"discover_unknown", 1}};
    options.settings = settings;
    options.setting_count = 2;
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
           track(4, false) && exclude() && track(5, true) && reset() && track(6, true) && track(7, false);
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
    const bool done = check(dot_track(tracker_, &frame));
    std::uint32_t count = 0;
    const dot_status status = dot_object_count(tracker_, &count);
    expect(status == (done ? DOT_OK : DOT_NO_RESULT), "a result if it was tracked", status, dot_last_error(tracker_));
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
};

void try_all(int threads, MemoryShortage::Duration duration) {
  cv::setNumThreads(threads);
  const Film film;
  {  // what OpenCV and the C++ library allocate once for the process
    MemoryShortage none(1L << 40, MemoryShortage::Once);
    ASSERT_TRUE(Life(film, threads, none).live());
  }
  bool reached = true;
  long k = 0;
  for (; reached && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE("allocation " + std::to_string(k) + " of a tracker's life fails");
    MemoryShortage shortage(k, duration);
    Life life(film, threads, shortage);
    life.live();
    if (duration == MemoryShortage::Lasting) life.go_on();
    reached = shortage.reached();
    shortage.end();
    life.expect_usable();
    EXPECT_STREQ(life.complaint(), "");
  }
  EXPECT_GT(k, 200) << "the film takes too little memory to tell anything";
  std::printf("%ld allocations\n", k);
}

TEST(MemoryShortage, HasEachKindOfAllocationFail) {
  const MemoryShortage shortage(0, MemoryShortage::Lasting);
  std::vector<int> numbers;
  EXPECT_THROW(numbers.resize(1000), std::bad_alloc);
  if (dot::test::AllocationCounter::sees_malloc()) {
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

TEST(OutOfMemory, OnceInOneThread) { try_all(1, MemoryShortage::Once); }
TEST(OutOfMemory, OnceInFourThreads) { try_all(4, MemoryShortage::Once); }
TEST(OutOfMemory, LastingInOneThread) { try_all(1, MemoryShortage::Lasting); }
TEST(OutOfMemory, LastingInFourThreads) { try_all(4, MemoryShortage::Lasting); }

}  // namespace
