// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Work and memory are bounded whatever comes in: many instances, many objects, many masks that fit none.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

#include "dot/dot.hpp"
#include "support/random.hpp"

namespace {

using dot::Dot;
using dot::Frame;
using dot::Image;
using dot::Options;
using dot::Pinhole;
using dot::PixelFormat;
using dot::Reason;
using dot::Result;

/// Aligns as the default does and counts how often it is asked to.
struct CountingAligner : dot::DirectAligner<> {
  int* count = nullptr;
  template <typename Problem>
  dot::Alignment align(const Problem& problem, const dot::AlignState& start, int coarsest, int finest = 0) {
    if (count) ++*count;
    return dot::DirectAligner<>::align(problem, start, coarsest, finest);
  }
};

/// A standing wall of noise 5 m ahead, covered with square instances on a grid.
class Wall {
 public:
  Wall(int columns, int rows, int size, int step) : columns_(columns), rows_(rows), size_(size), step_(step) {
    dot::test::Random random(3);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) grey_(x, y) = static_cast<std::uint8_t>(random.uniform(0, 256));
    depth_.fill(5);
  }
  static Pinhole camera() { return Pinhole({500, 500, kWidth / 2.0, kHeight / 2.0, kWidth, kHeight, 0}); }

  /// @param shift of the instances, pixels.
  const Frame& next(int shift = 0) {
    ids_.fill(0);
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c)
        for (int y = 0; y < size_; ++y)
          for (int x = 0; x < size_; ++x) {
            const int u = 4 + c * step_ + shift + x, v = 4 + r * step_ + y;
            if (ids_.contains(u, v)) ids_(u, v) = static_cast<std::uint32_t>(1 + r * columns_ + c);
          }
    frame_ = {};
    frame_.id = static_cast<std::uint64_t>(++index_);
    frame_.timestamp = 1.7e9 + 0.1 * index_;
    frame_.image = {grey_.row(0), kWidth, kHeight, kWidth, PixelFormat::Grey8};
    frame_.depth = {depth_.row(0), kWidth, kHeight, 4 * kWidth, PixelFormat::DepthF32};
    frame_.masks = dot::Masks{{ids_.row(0), kWidth, kHeight, 4 * kWidth, PixelFormat::Id32}, {}};
    return frame_;
  }
  const Image<std::uint32_t>& ids() const { return ids_; }

  static constexpr int kWidth = 640, kHeight = 480;

 private:
  int columns_, rows_, size_, step_, index_ = -1;
  Image<std::uint8_t> grey_{kWidth, kHeight};
  Image<float> depth_{kWidth, kHeight};
  Image<std::uint32_t> ids_{kWidth, kHeight};
  Frame frame_;
};

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Bounds, MoreInstancesThanAllowedAreRefusedByName) {
  Wall wall(20, 10, 12, 20);
  Options options;
  options.mask.max_instances = 199;
  Dot<> dot(Wall::camera(), options);
  const std::string message = refusal([&] { dot.track(wall.next()); });
  EXPECT_EQ(message.rfind("frame.masks.ids: has 200 instances, more than mask.max_instances, 199", 0), 0u) << message;

  std::vector<dot::Instance> list(200);
  Frame frame = wall.next();
  for (std::size_t i = 0; i < list.size(); ++i) list[i].id = static_cast<std::uint32_t>(i + 1);
  frame.masks.reset();
  dot.track(frame);
  dot::Masks masks{wall.ids().view().data ? dot::ImageRef{} : dot::ImageRef{}, {list.data(), list.size()}};
  Image<std::uint8_t> square(12, 12);
  square.fill(1);
  for (dot::Instance& instance : list) instance.mask = {square.row(0), 12, 12, 12, PixelFormat::Id8};
  const std::string late = refusal([&] { dot.submit_masks(frame.id, masks); });
  EXPECT_EQ(late.rfind("masks.instances: has 200 instances", 0), 0u) << late;
  masks.instances.size = 199;
  EXPECT_EQ(refusal([&] { dot.submit_masks(frame.id, masks); }), "accepted");
}

// A depth image that is passed as an id image has as many ids as values.
TEST(Bounds, AnImageOfSomethingElseIsRefused) {
  Wall wall(1, 1, 40, 50);
  Dot<> dot(Wall::camera());
  dot.track(wall.next());
  Image<std::uint16_t> depth(Wall::kWidth, Wall::kHeight);
  for (int y = 0; y < depth.height(); ++y)
    for (int x = 0; x < depth.width(); ++x) depth(x, y) = static_cast<std::uint16_t>(y * depth.width() + x);
  Frame frame = wall.next();
  frame.masks->ids = {depth.row(0), Wall::kWidth, Wall::kHeight, 2 * Wall::kWidth, PixelFormat::Id16};
  const std::string message = refusal([&] { dot.track(frame); });
  EXPECT_EQ(message.rfind("frame.masks.ids: has 65535 instances", 0), 0u) << message;
  const Result& result = dot.track(wall.next());
  EXPECT_EQ(result.objects.size, 1u);
  EXPECT_EQ(result.objects[0].reason, Reason::None);
}

// Noise of 250 ids: each of them has pixels all over the image.
TEST(Bounds, IdsThatAreStrewnOverTheImageAreRefused) {
  Wall wall(1, 1, 40, 50);
  Dot<> dot(Wall::camera());
  dot.track(wall.next());
  Image<std::uint8_t> noise(Wall::kWidth, Wall::kHeight);
  dot::test::Random random(8);
  for (int y = 0; y < noise.height(); ++y)
    for (int x = 0; x < noise.width(); ++x) noise(x, y) = static_cast<std::uint8_t>(random.uniform(0, 251));
  Frame frame = wall.next();
  frame.masks->ids = {noise.row(0), Wall::kWidth, Wall::kHeight, Wall::kWidth, PixelFormat::Id8};
  const std::string message = refusal([&] { dot.track(frame); });
  EXPECT_EQ(message.rfind("frame.masks.ids: has instances that are strewn over it", 0), 0u) << message;
  EXPECT_EQ(dot.track(wall.next()).objects[0].reason, Reason::None);
}

// A list may overlap as much as ids are strewn, no more: each mask may meet each other one.
TEST(Bounds, MasksOfAListThatOverlapTooMuchAreRefused) {
  Wall wall(1, 1, 40, 50);
  Dot<> dot(Wall::camera());
  dot.track(wall.next());
  Image<std::uint8_t> all(Wall::kWidth, Wall::kHeight);
  all.fill(1);
  std::vector<dot::Instance> list(34);
  list[0].mask.width = -1000000, list[0].mask.height = 480;  // its pixels are in the id image: the size says nothing
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].id = static_cast<std::uint32_t>(i + 1);
    if (i == 0) continue;
    list[i].mask = {all.row(0), Wall::kWidth, Wall::kHeight, Wall::kWidth, PixelFormat::Id8};
  }
  Frame frame = wall.next();
  const Frame with_ids = frame;
  frame.masks->instances = {list.data(), list.size()};
  const std::string message = refusal([&] { dot.track(frame); });
  EXPECT_EQ(message.rfind("frame.masks.instances: has masks that overlap too much", 0), 0u) << message;
  EXPECT_EQ(dot.track(with_ids).objects[0].reason, Reason::None);

  // As many images of full size, each with one small instance, as most networks give them.
  Image<std::uint8_t> small(Wall::kWidth, Wall::kHeight);
  small.fill(0);
  for (int y = 100; y < 140; ++y)
    for (int x = 100; x < 140; ++x) small(x, y) = 1;
  list.erase(list.begin());
  for (dot::Instance& instance : list) instance.mask.data = small.row(0);
  frame = wall.next();
  frame.masks = dot::Masks{{}, {list.data(), list.size()}};
  EXPECT_EQ(refusal([&] { dot.track(frame); }), "accepted");
}

TEST(Bounds, SmallMasksStartNoTrackAndAreCounted) {
  Wall wall(20, 10, 5, 20);  // 25 pixels each
  Dot<> dot(Wall::camera());
  for (int i = 0; i < 3; ++i) {
    const Result& result = dot.track(wall.next());
    EXPECT_EQ(result.objects.size, 0u);
    EXPECT_EQ(result.small_instances, 200);
  }
  Frame frame = wall.next();
  frame.masks.reset();
  EXPECT_EQ(dot.track(frame).small_instances, 0);
}

TEST(Bounds, TheLargestObjectsAreFollowedAndTheOthersSayWhyNot) {
  Wall wall(16, 8, 20, 30);
  Options options;
  options.object.max_fitted = 30;
  Dot<> dot(Wall::camera(), options);
  for (int i = 0; i < 6; ++i) {
    const Result& result = dot.track(wall.next());
    ASSERT_EQ(result.objects.size, 128u);
    if (i < 1) continue;
    std::map<Reason, int> reasons;
    for (const dot::ObjectResult& object : result.objects) {
      ++reasons[object.reason];
      EXPECT_EQ(object.id, object.instance_id) << "each keeps its id";
      EXPECT_GT(object.area, 0);
      EXPECT_NE(object.state, dot::State::Moving);
    }
    EXPECT_EQ(reasons[Reason::TooManyObjects], 98) << "frame " << i;
  }
}

// Instances that jump so far that none is found again: tracks do not pile up.
TEST(Bounds, TracksAreNoMoreThanTwiceTheInstancesAllowed) {
  Wall wall(6, 5, 16, 96);  // each has six places
  Options options;
  options.object.max_fitted = 4;
  options.mask.max_instances = 30;
  options.mask.keep_seconds = 10;
  Dot<> dot(Wall::camera(), options);
  std::size_t most = 0;
  for (int i = 0; i < 12; ++i) most = std::max(most, dot.track(wall.next(i % 6 * 16)).objects.size);
  EXPECT_GT(most, 60u);
  EXPECT_LE(most, 60u + 30u) << "those that are dropped are told of once";
}

#ifndef DOT_TEST_DEFAULT_POLICIES
/// Alignments that each object costs in a frame of which no mask belongs to any of them.
double alignments_per_object(int columns, int rows) {
  Wall wall(columns, rows, 16, 48);
  Dot<Pinhole, dot::VelocityClassifier, dot::DepthNoise, CountingAligner> dot(Wall::camera());
  int count = 0;
  dot.aligner.count = &count;
  dot.track(wall.next());
  count = 0;
  const Result& result = dot.track(wall.next(24));
  EXPECT_EQ(result.objects.size, static_cast<std::size_t>(2 * columns * rows));
  return static_cast<double>(count) / (columns * rows);
}

TEST(Bounds, MasksThatFitNothingCostEachObjectTheSame) {
  const double few = alignments_per_object(2, 2), many = alignments_per_object(12, 8);
  EXPECT_GT(few, 1);
  EXPECT_LT(many, 3 * few) << "starts grow with the number of masks";
}
#endif

}  // namespace
