// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/pipeline/exclusion.hpp"

#include <cstdint>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dot/image/image.hpp"

namespace {

using dot::ExclusionPolicy;
using dot::Image;
using dot::State;

/// A labelled frame of 5x5 squares side by side, one object each, on background.
struct Labelled {
  explicit Labelled(const std::vector<dot::ObjectResult>& list)
      : objects(list), labels(10 * static_cast<int>(list.size()) + 10, 20), ids(labels.width(), 20) {
    labels.fill(0);
    ids.fill(0);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      objects[i].id = static_cast<std::uint32_t>(i) + 100;
      for (int v = 8; v < 13; ++v) {
        for (int u = left(i); u < left(i) + 5; ++u) {
          labels(u, v) = static_cast<std::uint8_t>(objects[i].state);
          ids(u, v) = objects[i].id;
        }
      }
    }
    const Image<std::uint8_t>& l = labels;
    const Image<std::uint32_t>& n = ids;
    result.labels = l.view();
    result.ids = n.view();
    result.objects = {objects.data(), objects.size()};
  }

  static int left(std::size_t i) { return 10 * static_cast<int>(i) + 8; }

  Image<std::uint8_t> mask(const ExclusionPolicy& policy) const {
    Image<std::uint8_t> out(labels.width(), labels.height());
    out.fill(123);
    dot::exclusion_mask(result, policy, out.view());
    return out;
  }

  std::vector<dot::ObjectResult> objects;
  Image<std::uint8_t> labels;
  Image<std::uint32_t> ids;
  dot::Result result;
};

dot::ObjectResult object(State state, State last_decided) {
  dot::ObjectResult out;
  out.state = state;
  out.last_decided = last_decided;
  return out;
}

/// All the ways in which an object's state and history combine.
const std::vector<dot::ObjectResult> kObjects{
    object(State::Moving, State::Moving), object(State::Static, State::Static),
    object(State::NotObservable, State::Moving), object(State::NotObservable, State::Static),
    object(State::NotObservable, State::NotObservable)};

void expect_excluded(const ExclusionPolicy& policy, const std::vector<bool>& expected) {
  const Labelled frame(kObjects);
  const Image<std::uint8_t> mask = frame.mask(policy);
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      bool inside = false;
      for (std::size_t i = 0; i < expected.size(); ++i)
        inside = inside ||
                 (expected[i] && u >= Labelled::left(i) - policy.dilation &&
                  u < Labelled::left(i) + 5 + policy.dilation && v >= 8 - policy.dilation && v < 13 + policy.dilation);
      ASSERT_EQ(mask(u, v), inside ? 255 : 0) << u << ' ' << v;
    }
  }
}

TEST(Exclusion, ExcludesMoversAndWhatWasNeverDecided) {
  ExclusionPolicy policy;
  policy.dilation = 0;
  expect_excluded(policy, {true, false, true, false, true});
}

TEST(Exclusion, UndecidedMayBeKept) {
  ExclusionPolicy policy;
  policy.dilation = 0;
  policy.exclude_not_observable = false;
  expect_excluded(policy, {true, false, true, false, false});
}

TEST(Exclusion, StaticMayBeExcluded) {
  ExclusionPolicy policy;
  policy.dilation = 0;
  policy.exclude_static = true;
  expect_excluded(policy, {true, true, true, true, true});
  policy.exclude_not_observable = false;
  expect_excluded(policy, {true, true, true, true, false});
}

TEST(Exclusion, IsWidenedByTheDilation) {
  ExclusionPolicy policy;
  for (const int dilation : {1, 2, 3, 8, 40}) {
    policy.dilation = dilation;
    expect_excluded(policy, {true, false, true, false, true});
  }
}

TEST(Exclusion, DilationEqualsBruteForce) {
  std::mt19937 random(9);
  for (int round = 0; round < 30; ++round) {
    const int width = 1 + static_cast<int>(random() % 40), height = 1 + static_cast<int>(random() % 30);
    Image<std::uint8_t> labels(width, height);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        labels(u, v) = static_cast<std::uint8_t>(random() % 40 == 0 ? State::Moving : State::Background);
    dot::Result result;
    result.labels = {labels.row(0), width, height, width};
    ExclusionPolicy policy;
    policy.dilation = static_cast<int>(random() % 6);
    Image<std::uint8_t> mask(width, height);
    dot::exclusion_mask(result, policy, mask.view());
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        bool expected = false;
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x)
            expected = expected ||
                       (labels(x, y) != 0 && std::abs(x - u) <= policy.dilation && std::abs(y - v) <= policy.dilation);
        ASSERT_EQ(mask(u, v), expected ? 255 : 0) << u << ' ' << v;
      }
    }
  }
}

TEST(Exclusion, WithoutIdsTheLabelDecides) {
  Labelled frame(kObjects);
  frame.result.ids = {};
  ExclusionPolicy policy;
  policy.dilation = 0;
  const Image<std::uint8_t> mask = frame.mask(policy);
  const std::vector<int> expected{255, 0, 255, 255, 255};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(mask(Labelled::left(i), 10), expected[i]) << i;
}

TEST(Exclusion, FeatureMaskIsTheOppositeOfTheExclusionMask) {
  const Labelled frame({object(State::Moving, State::Moving), object(State::Static, State::Static)});
  const Image<std::uint8_t> excluded = frame.mask({});
  Image<std::uint8_t> features(excluded.width(), excluded.height());
  dot::feature_mask(frame.result, {}, features.view());
  for (int v = 0; v < excluded.height(); ++v)
    for (int u = 0; u < excluded.width(); ++u) ASSERT_EQ(features(u, v), 255 - excluded(u, v)) << u << ", " << v;
  EXPECT_EQ(features(Labelled::left(0), 10), 0);
  EXPECT_EQ(features(Labelled::left(1), 10), 255);
}

TEST(Exclusion, MaskedShareIsThatOfTheMaskBeforeItIsWidened) {
  const std::vector<dot::ObjectResult> states{
      object(State::Moving, State::Moving), object(State::Static, State::Static),
      object(State::NotObservable, State::NotObservable), object(State::NotObservable, State::Static),
      object(State::NotObservable, State::Moving)};
  Labelled frame(states);
  for (dot::ObjectResult& o : frame.objects) o.area = 25;
  for (const bool exclude_static : {false, true}) {
    for (const bool exclude_not_observable : {false, true}) {
      const ExclusionPolicy policy{exclude_not_observable, exclude_static, 0};
      const Image<std::uint8_t> mask = frame.mask(policy);
      int excluded = 0;
      for (int v = 0; v < mask.height(); ++v)
        for (int u = 0; u < mask.width(); ++u) excluded += mask(u, v) == 255;
      EXPECT_GT(excluded, 0);
      EXPECT_DOUBLE_EQ(dot::masked_share(frame.result, policy) * mask.width() * mask.height(), excluded);
    }
  }
  EXPECT_EQ(dot::masked_share(dot::Result{}), 0);
}

TEST(Exclusion, RespectsTheStride) {
  const Labelled frame(kObjects);
  const int width = frame.labels.width(), height = frame.labels.height(), stride = width + 13;
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(stride * height), 7);
  const ExclusionPolicy policy;
  dot::exclusion_mask(frame.result, policy, {memory.data(), width, height, stride});
  const Image<std::uint8_t> expected = frame.mask(policy);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < stride; ++u)
      ASSERT_EQ(memory[static_cast<std::size_t>(v * stride + u)], u < width ? expected(u, v) : 7) << u << ' ' << v;
}

/// The message of the exception that a call throws.
template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no exception";
}

TEST(Exclusion, RefusesBadArguments) {
  const Labelled frame(kObjects);
  const int width = frame.labels.width(), height = frame.labels.height();
  for (const auto& [w, h] : std::vector<std::pair<int, int>>{{width - 1, height}, {width, height + 1}, {0, 0}}) {
    Image<std::uint8_t> out(w, h);
    out.fill(9);
    EXPECT_EQ(message_of([&] { dot::exclusion_mask(frame.result, {}, out.view()); }),
              "out must have the size of result.labels");
    for (int v = 0; v < h; ++v)
      for (int u = 0; u < w; ++u) ASSERT_EQ(out(u, v), 9);
  }
  EXPECT_THROW(dot::exclusion_mask(frame.result, {}, {nullptr, width, height, width}), std::invalid_argument);
  ExclusionPolicy policy;
  policy.dilation = -1;
  EXPECT_EQ(message_of([&] { frame.mask(policy); }), "policy.dilation must be >= 0");
}

}  // namespace
