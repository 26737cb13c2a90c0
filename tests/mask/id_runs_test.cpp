// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/mask/id_runs.hpp"

#include <cstdint>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/consistent_mask.hpp"

namespace {

using dot::ImageRef;
using dot::ImageView;
using dot::Mask;
using dot::PixelFormat;
using dot::test::expect_consistent;

using Split = std::vector<std::pair<std::uint32_t, Mask>>;

void split(const ImageRef& ids, Split& out) {
  dot::IdRuns runs;
  runs.runs.push_back({1, 2, 3, 4});  // of an earlier image
  dot::find_runs(ids, runs);
  out.clear();
  dot::split_ids(runs, [&](std::uint32_t id) -> Mask& { return out.emplace_back(id, Mask{}).second; });
  EXPECT_EQ(runs.instances.size(), out.size());
  double boxes = 0;
  for (const auto& [id, mask] : out) boxes += 1.0 * mask.width() * mask.height();
  EXPECT_EQ(runs.box_area, boxes);
}

/// An id image of blobs, with rows longer than the image.
template <typename T>
void check_split(PixelFormat format, T largest) {
  constexpr int width = 137, height = 23, stride = 148;  // runs that are longer than the words compared at once
  std::mt19937 random(2);
  const std::vector<T> choice{0, 1, 2, 9, static_cast<T>(largest - 1), largest};
  Split found;
  for (int round = 0; round < 20; ++round) {
    std::uniform_int_distribution<std::size_t> pick(0, round % 2 == 0 ? choice.size() - 1 : 2);
    std::vector<T> pixels(stride * height, T{9});
    T id = 0;
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        pixels[static_cast<std::size_t>(v * stride + u)] = id = random() % 4 == 0 ? choice[pick(random)] : id;

    const ImageView<const T> view{pixels.data(), width, height, stride * sizeof(T)};
    split({pixels.data(), width, height, stride * sizeof(T), format, 1}, found);
    std::map<std::uint32_t, int> areas;
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        if (view(u, v) != 0) ++areas[view(u, v)];
    ASSERT_EQ(found.size(), areas.size());
    auto expected = areas.begin();
    for (const auto& [key, mask] : found) {
      EXPECT_EQ(key, expected->first);
      EXPECT_EQ(mask.area, expected->second);
      expect_consistent(mask);
      for (int v = 0; v < height; ++v)
        for (int u = 0; u < width; ++u) ASSERT_EQ(mask.at(u, v), view(u, v) == key) << u << ' ' << v;
      Mask cropped;
      dot::crop_ids(view, key, {-5, -5, 1000, 1000}, cropped);
      EXPECT_EQ(cropped.box(), mask.box());
      EXPECT_EQ(dot::overlap(cropped, mask), mask.area);
      ++expected;
    }
  }
}

TEST(IdRuns, SplitIdImages) {
  check_split<std::uint8_t>(PixelFormat::Id8, 255);
  check_split<std::uint16_t>(PixelFormat::Id16, 65535);
  check_split<std::uint32_t>(PixelFormat::Id32, 4294967295u);
}

TEST(IdRuns, OfAnEmptyImageForgetEarlierOnes) {
  Split found(3);
  const std::vector<std::uint8_t> zeros(12);
  split({zeros.data(), 4, 3, 4, PixelFormat::Id8, 1}, found);
  EXPECT_TRUE(found.empty());
}

TEST(IdRuns, RefuseOtherFormats) {
  Split found;
  const std::vector<std::uint8_t> zeros(12);
  EXPECT_THROW(split({zeros.data(), 4, 3, 4, PixelFormat::Grey8, 1}, found), std::invalid_argument);
}

}  // namespace
