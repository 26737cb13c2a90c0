// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/view.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "dot/image/image.hpp"
#include "dot/image/span.hpp"

namespace {

using dot::Image;
using dot::ImageRef;
using dot::ImageView;
using dot::PixelFormat;

TEST(ImageView, StrideIsInBytes) {
  std::array<std::uint16_t, 30> memory{};
  std::iota(memory.begin(), memory.end(), std::uint16_t{0});
  const ImageView<std::uint16_t> view{memory.data() + 2, 3, 3, 10 * sizeof(std::uint16_t)};
  EXPECT_EQ(view(0, 0), 2);
  EXPECT_EQ(view(2, 1), 14);
  EXPECT_EQ(view(1, 2), 23);
  EXPECT_EQ(view.row(2), memory.data() + 22);
  view(1, 1) = 99;
  EXPECT_EQ(memory[13], 99);
}

TEST(ImageView, RowsMayRunUpwards) {
  std::array<float, 6> memory{0, 1, 2, 3, 4, 5};
  const ImageView<const float> flipped{memory.data() + 4, 2, 3, -2 * static_cast<std::ptrdiff_t>(sizeof(float))};
  EXPECT_EQ(flipped(0, 0), 4);
  EXPECT_EQ(flipped(1, 1), 3);
  EXPECT_EQ(flipped(1, 2), 1);
}

TEST(ImageView, OfMutablePixelsServesAsOneOfConst) {
  std::array<std::uint8_t, 4> memory{1, 2, 3, 4};
  const ImageView<std::uint8_t> view{memory.data(), 2, 2, 2};
  const ImageView<const std::uint8_t> read_only = view;
  EXPECT_EQ(read_only.row(1), memory.data() + 2);
  EXPECT_EQ(read_only.width, 2);
  EXPECT_EQ(read_only.height, 2);
  EXPECT_EQ(read_only.stride, 2);
}

TEST(ImageView, KnowsWhatItContains) {
  std::array<std::uint8_t, 12> memory{};
  const ImageView<std::uint8_t> view{memory.data(), 4, 3, 4};
  EXPECT_TRUE(view.contains(0, 0));
  EXPECT_TRUE(view.contains(3, 2));
  EXPECT_FALSE(view.contains(4, 2));
  EXPECT_FALSE(view.contains(3, 3));
  EXPECT_FALSE(view.contains(-1, 0));
  EXPECT_FALSE(view.contains(0, -1));
}

TEST(ImageView, IsEmptyWithoutMemoryOrPixels) {
  std::uint8_t pixel = 0;
  EXPECT_TRUE(ImageView<std::uint8_t>{}.empty());
  EXPECT_TRUE((ImageView<std::uint8_t>{nullptr, 1, 1, 1}.empty()));
  EXPECT_TRUE((ImageView<std::uint8_t>{&pixel, 0, 1, 1}.empty()));
  EXPECT_TRUE((ImageView<std::uint8_t>{&pixel, 1, -1, 1}.empty()));
  EXPECT_FALSE((ImageView<std::uint8_t>{&pixel, 1, 1, 1}.empty()));
  EXPECT_TRUE(ImageRef{}.empty());
  EXPECT_TRUE((ImageRef{&pixel, 1, 0, 1}.empty()));
  EXPECT_FALSE((ImageRef{&pixel, 1, 1, 1}.empty()));
}

TEST(PixelFormats, TakeTheirBytes) {
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Grey8), 1);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Bgr8), 3);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Rgb8), 3);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Bgra8), 4);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::DepthF32), 4);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::DepthU16), 2);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Id8), 1);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Id16), 2);
  EXPECT_EQ(dot::bytes_per_pixel(PixelFormat::Id32), 4);
  EXPECT_EQ(dot::bytes_per_pixel(static_cast<PixelFormat>(200)), 0);
}

TEST(OwnedImage, RowsFollowEachOther) {
  Image<std::uint32_t> image(5, 4);
  EXPECT_EQ(image.width(), 5);
  EXPECT_EQ(image.height(), 4);
  image.fill(7);
  image(4, 3) = 8;
  EXPECT_EQ(image.row(3), image.row(0) + 15);
  EXPECT_EQ(std::accumulate(image.row(0), image.row(0) + 20, 0u), 19 * 7u + 8u);
  EXPECT_EQ(image.view().stride, static_cast<std::ptrdiff_t>(5 * sizeof(std::uint32_t)));
  EXPECT_EQ(image.view()(4, 3), 8u);
  const Image<std::uint32_t>& read_only = image;
  EXPECT_EQ(read_only.view().data, image.view().data);
  EXPECT_TRUE(image.contains(4, 3));
  EXPECT_FALSE(image.contains(5, 3));
  EXPECT_FALSE(image.contains(-1, 0));
}

TEST(OwnedImage, KeepsItsMemoryWhenItShrinks) {
  Image<float> image(64, 48);
  const float* const memory = image.row(0);
  image.resize(32, 20);
  image.resize(48, 64);
  EXPECT_EQ(image.row(0), memory);
  EXPECT_EQ(image.width(), 48);
  EXPECT_EQ(image.height(), 64);
  EXPECT_FALSE(image.empty());
  EXPECT_TRUE(Image<float>().empty());
}

TEST(Span, IsARunOfElements) {
  const std::array<int, 3> owner{4, 5, 6};
  const dot::Span<int> span{owner.data(), owner.size()};
  EXPECT_EQ(std::accumulate(span.begin(), span.end(), 0), 15);
  EXPECT_EQ(span[2], 6);
  EXPECT_FALSE(span.empty());
  EXPECT_TRUE(dot::Span<int>{}.empty());
}

}  // namespace
