// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/frame/frame_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/kernel/portable_kernels.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::FramePtr;
using dot::FrameStore;

const dot::DepthNoise kNoise;

/// A frame of one grey value, 2 m away.
struct Plain {
  std::vector<std::uint8_t> grey;
  std::vector<float> depth;
  dot::Frame frame;
  explicit Plain(std::uint8_t value) : grey(280 * 96, value), depth(280 * 96, 2.f) {
    frame.id = value;
    frame.timestamp = 0.1 * value;
    frame.image = {grey.data(), 280, 96, 280, dot::PixelFormat::Grey8};
    frame.depth = {depth.data(), 280, 96, 280 * 4, dot::PixelFormat::DepthF32};
  }
};

FramePtr add(FrameStore& store, std::uint8_t value, double max_depth = 100, const dot::DepthBias& bias = {}) {
  const Plain plain(value);
  return store.add(plain.frame, bias, kNoise, {3, max_depth}, dot::portable_kernels(), dot::Threads{});
}

TEST(FrameStore, BuildsBothPyramids) {
  FrameStore store;
  const FramePtr frame = add(store, 7);
  EXPECT_EQ(frame->id, 7u);
  EXPECT_EQ(frame->timestamp, 0.1 * 7);
  ASSERT_EQ(frame->pyramid.size(), 3);
  EXPECT_EQ(frame->pyramid.levels[2].width(), 70);
  EXPECT_EQ(frame->pyramid.levels[2](3, 3), 7);
  EXPECT_EQ(frame->inverse_depth()(10, 10), 0.5f);
}

TEST(FrameStore, FartherThanTheLimitIsNotMeasured) {
  FrameStore store;
  EXPECT_LE(add(store, 1, 1.5)->inverse_depth()(10, 10), 0);
}

TEST(FrameStore, SaturatedIsNotMeasuredAndBoundsNothingElse) {
  FrameStore store;
  dot::DepthBias bias;
  bias.coefficients[0] = 0.2;  // 2 m become 3.3 m
  for (const auto& [saturated, expected] : {std::pair{2.0, 0.0f}, std::pair{2.1, 0.3f}}) {
    const Plain plain(1);
    const FramePtr frame =
        store.add(plain.frame, bias, kNoise, {3, 100, saturated}, dot::portable_kernels(), dot::Threads{});
    EXPECT_NEAR(frame->inverse_depth()(10, 10), expected, 1e-6f) << saturated;
  }
}

TEST(FrameStore, SubtractsTheBias) {
  FrameStore store;
  dot::DepthBias bias;
  bias.coefficients[0] = 0.1;
  const FramePtr frame = add(store, 1, 100, bias);
  EXPECT_NEAR(frame->inverse_depth()(10, 10), 0.4f, 1e-6f);
  EXPECT_EQ(frame->bias.coefficients, bias.coefficients);
}

FramePtr add(FrameStore& store, Plain& plain) {
  return store.add(plain.frame, {}, kNoise, {3, 100}, dot::portable_kernels(), dot::Threads{});
}

TEST(FrameStore, CountsRepeatedImages) {
  FrameStore store;
  const auto after = [&store](const FramePtr& previous, std::uint8_t grey, double depth) {
    Plain plain(grey);
    plain.depth.assign(plain.depth.size(), static_cast<float>(depth));
    return store.add(plain.frame, {}, kNoise, {3, 100}, dot::portable_kernels(), dot::Threads{}, previous.get());
  };
  FramePtr frame = after(nullptr, 7, 2);
  EXPECT_EQ(frame->repeats, 0);
  for (int i = 1; i <= dot::FrameData::kLongestRun + 1; ++i) {
    frame = after(frame, 7, 2 + 0.1 * i);  // a depth of its own makes no other image
    EXPECT_EQ(frame->repeats, i);
    EXPECT_EQ(frame->is_repeated(), i <= dot::FrameData::kLongestRun);
  }
  frame = after(frame, 8, 2);
  EXPECT_EQ(frame->repeats, 0);
  EXPECT_FALSE(frame->is_repeated());
}

/// Bands of flickering light on a plain image.
void light(Plain& plain, double phase) {
  for (std::size_t i = 0; i < plain.grey.size(); ++i) {
    const double turns = 3.0 * static_cast<double>(i / 280) / 96 + phase;
    plain.grey[i] = static_cast<std::uint8_t>(120 * (1 + 0.15 * std::sin(6.283185307179586 * turns)));
  }
}

TEST(FrameStore, RemovesFlickerAndStillKnowsARepeatedImage) {
  FrameStore store;
  Plain plain(1);
  FramePtr frame;
  for (const auto& [phase, repeats] : {std::pair{0.0, 0}, {0.3, 0}, {0.3, 1}, {0.7, 0}}) {
    light(plain, phase);
    const FramePtr last = frame;
    frame = store.add(plain.frame, {}, kNoise, {3, 100}, dot::portable_kernels(), dot::Threads{}, last.get());
    EXPECT_EQ(frame->repeats, repeats) << "phase " << phase;
    if (!last) continue;
    for (std::size_t level = 0; level < 3; ++level) {
      const dot::Image<std::uint8_t>&now = frame->pyramid.levels[level], &before = last->pyramid.levels[level];
      for (int y = 0; y < now.height(); ++y)
        EXPECT_NEAR(now(30, y), before(30, y), 6) << "of 35, phase " << phase << ", level " << level << ", row " << y;
    }
  }
}

TEST(FrameStore, FillsInSparseDepth) {
  FrameStore store;
  Plain plain(1);
  for (std::size_t i = 0; i < plain.depth.size(); ++i) plain.depth[i] = i % 19 == 0 ? 2.f : 0.f;
  const FramePtr frame = add(store, plain);
  for (int x = 20; x < 260; ++x) ASSERT_NEAR(frame->inverse_depth()(x, 48), 0.5f, 1e-5f) << x;
  EXPECT_NEAR(frame->depth.levels[1](70, 24), 0.5f, 1e-5f);
}

TEST(FrameStore, FillsInBeamsOnAnyRows) {
  FrameStore store;
  for (std::size_t first = 0; first < 8; ++first) {
    Plain plain(1);
    for (std::size_t i = 0; i < plain.depth.size(); ++i) plain.depth[i] = (i / 280) % 8 == first ? 2.f : 0.f;
    const FramePtr frame = add(store, plain);
    for (int y = 20; y < 70; ++y) ASSERT_NEAR(frame->inverse_depth()(100, y), 0.5f, 1e-5f) << first << ' ' << y;
  }
}

TEST(FrameStore, LeavesDepthAloneThatIsDenseInAPart) {
  FrameStore store;
  Plain plain(1);
  for (std::size_t i = 0; i < plain.depth.size(); ++i) {
    const std::size_t x = i % 280, y = i / 280;
    plain.depth[i] = x < 60 && y < 40 ? 2.f + 0.01f * static_cast<float>(i % 7) : 0.f;
  }
  const FramePtr frame = add(store, plain);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 280; ++x) {
      const float z = plain.depth[static_cast<std::size_t>(y * 280 + x)];
      ASSERT_EQ(frame->inverse_depth()(x, y) > 0, z > 0) << x << ' ' << y;
      ASSERT_NEAR(frame->inverse_depth()(x, y), z > 0 ? 1 / z : 0, 1e-6f) << x << ' ' << y;
    }
}

TEST(FrameStore, LeavesAloneWhatIsLent) {
  FrameStore store;
  const FramePtr kept = add(store, 1);
  for (std::uint8_t value = 2; value < 20; ++value) add(store, value);
  EXPECT_EQ(kept->id, 1u);
  EXPECT_EQ(kept->pyramid.levels[0](5, 5), 1);
}

TEST(FrameStore, UsesItsMemoryAgain) {
  FrameStore store;
  std::set<const std::uint8_t*> seen;
  FramePtr previous, current;
  for (std::uint8_t value = 1; value < 20; ++value) {
    previous = std::move(current);
    current = add(store, value);
    seen.insert(current->pyramid.levels[0].row(0));
  }
  EXPECT_EQ(seen.size(), 2u) << "the new frame is built while the one before is held";
}

TEST(FrameStore, TheSecondFramesMemoryIsNotTheFirsts) {
  FrameStore store;
  store.prepare_second();
  const FramePtr first = add(store, 1);
  store.prepare_second();
  const FramePtr second = add(store, 2);
  store.prepare_second();
  EXPECT_EQ(first->id, 1u);
  EXPECT_EQ(first->pyramid.levels[0](5, 5), 1);
  EXPECT_EQ(second->id, 2u);
  EXPECT_EQ(second->pyramid.levels[0](5, 5), 2);
}

}  // namespace
