// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Motions of the camera that were wrong come out of the C library as out of the C++ one.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "dot/dot.h"
#include "dot/tracker.hpp"
#include "support/lorry.hpp"

namespace {

using namespace dot::test;

constexpr int kMasked = 2;  ///< the frame from which on the network sees the lorry

Film<> film_of_lorry() { return behind_a_lorry(straight({0, 0, 0}, {0, 0, 3}), kMasked); }

std::unique_ptr<dot_tracker, void (*)(dot_tracker*)> c_tracker() {
  const dot::Intrinsics in = small_camera();
  dot_camera camera = DOT_CAMERA_INIT;
  camera.width = in.width, camera.height = in.height;
  camera.fx = in.fx, camera.fy = in.fy, camera.cx = in.cx, camera.cy = in.cy;
  camera.baseline = in.baseline;
  dot_tracker* tracker = nullptr;
  EXPECT_EQ(dot_create(&camera, nullptr, &tracker), DOT_OK) << dot_create_error();
  return {tracker, dot_destroy};
}

dot_image view(const dot::ImageRef& in, std::uint32_t format) {
  dot_image image = DOT_IMAGE_INIT;
  image.format = format;
  image.width = in.width, image.height = in.height;
  image.stride_bytes = in.stride;
  image.data = in.data;
  return image;
}

dot_status track(dot_tracker* tracker, const dot::Frame& in) {
  const dot_image image = view(in.image, DOT_FORMAT_GREY8), depth = view(in.depth, DOT_FORMAT_DEPTH_F32),
                  ids = view(in.masks->ids, DOT_FORMAT_ID32);
  dot_masks masks = DOT_MASKS_INIT;
  masks.ids = &ids;
  dot_frame frame = DOT_FRAME_INIT;
  frame.id = in.id;
  frame.timestamp = in.timestamp;
  frame.image = &image, frame.depth = &depth, frame.masks = &masks;
  return dot_track(tracker, &frame);
}

TEST(Revision, IsThatOfCpp) {
  Film<> film = film_of_lorry();
  dot::Tracker tracker(small_camera(), dot::Options{});
  const auto c = c_tracker();
  ASSERT_NE(c, nullptr);
  std::uint32_t all = 0, count = 0;
  dot_camera_revision revision = DOT_CAMERA_REVISION_INIT;
  for (int i = 0; i < kMasked + 3; ++i) {
    const dot::Result& result = film.next(tracker);
    ASSERT_EQ(track(c.get(), film.frame()), DOT_OK) << dot_last_error(c.get());
    ASSERT_EQ(dot_revision_count(c.get(), &count), DOT_OK);
    ASSERT_EQ(count, result.revised.size) << i;
    for (std::uint32_t k = 0; k < count; ++k) {
      const dot::CameraRevision& expected = result.revised[k];
      ASSERT_EQ(dot_get_revision(c.get(), k, &revision), DOT_OK);
      EXPECT_EQ(revision.struct_size, sizeof revision);
      EXPECT_EQ(revision.reserved, 0U);
      EXPECT_EQ(revision.frame_id, expected.frame_id);
      EXPECT_EQ(revision.timestamp, expected.timestamp);
      EXPECT_TRUE(std::equal(expected.T_cur_prev.begin(), expected.T_cur_prev.end(), revision.T_cur_prev));
      EXPECT_TRUE(std::equal(expected.covariance.begin(), expected.covariance.end(), revision.covariance));
    }
    EXPECT_EQ(dot_get_revision(c.get(), count, &revision), DOT_INVALID_ARGUMENT);
    all += count;
  }
  EXPECT_EQ(all, static_cast<std::uint32_t>(kMasked));
}

TEST(Revision, GoesIntoNoStructOfAnotherSize) {
  Film<> film = film_of_lorry();
  const auto c = c_tracker();
  ASSERT_NE(c, nullptr);
  for (int i = 0; i < kMasked + 2; ++i) ASSERT_EQ(track(c.get(), film.advance()), DOT_OK);
  std::uint32_t count = 0;
  ASSERT_EQ(dot_revision_count(c.get(), &count), DOT_OK);
  ASSERT_GT(count, 0U);
  dot_camera_revision revision = DOT_CAMERA_REVISION_INIT;
  for (std::uint32_t size = 0; size < sizeof revision + 16; ++size) {
    revision.struct_size = size;
    EXPECT_EQ(dot_get_revision(c.get(), 0, &revision), size == sizeof revision ? DOT_OK : DOT_INVALID_ARGUMENT) << size;
  }
  EXPECT_EQ(dot_get_revision(c.get(), 0, nullptr), DOT_INVALID_ARGUMENT);
  ASSERT_EQ(dot_reset(c.get()), DOT_OK);
  EXPECT_EQ(dot_revision_count(c.get(), &count), DOT_NO_RESULT);
  EXPECT_EQ(count, 0U);
}

}  // namespace
