// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/image/opencv.hpp"

#include <gtest/gtest.h>

#include <string>

#include "dot/image/image.hpp"

namespace {

template <typename Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no exception";
}

void expect_borrowed(const dot::ImageRef& ref, const cv::Mat& image, dot::PixelFormat format) {
  EXPECT_EQ(ref.data, image.data);
  EXPECT_EQ(ref.width, image.cols);
  EXPECT_EQ(ref.height, image.rows);
  EXPECT_EQ(ref.stride, static_cast<std::ptrdiff_t>(image.step[0]));
  EXPECT_EQ(ref.format, format);
  EXPECT_EQ(dot::bytes_per_pixel(ref.format), static_cast<int>(image.elemSize()));
}

TEST(OpenCv, ImageFormats) {
  const cv::Mat grey(5, 7, CV_8UC1), bgr(5, 7, CV_8UC3), bgra(5, 7, CV_8UC4);
  expect_borrowed(dot::view(grey), grey, dot::PixelFormat::Grey8);
  expect_borrowed(dot::view(bgr), bgr, dot::PixelFormat::Bgr8);
  expect_borrowed(dot::view(bgra), bgra, dot::PixelFormat::Bgra8);
}

TEST(OpenCv, DepthFormatsCarryTheirUnits) {
  const cv::Mat metres(5, 7, CV_32FC1), units(5, 7, CV_16UC1);
  expect_borrowed(dot::depth_view(metres), metres, dot::PixelFormat::DepthF32);
  expect_borrowed(dot::depth_view(units), units, dot::PixelFormat::DepthU16);
  EXPECT_EQ(dot::depth_view(units).depth_units_per_metre, 1000);
  EXPECT_EQ(dot::depth_view(units, 256).depth_units_per_metre, 256);
}

TEST(OpenCv, IdFormats) {
  const cv::Mat id8(5, 7, CV_8UC1), id16(5, 7, CV_16UC1), id32(5, 7, CV_32SC1);
  expect_borrowed(dot::id_view(id8), id8, dot::PixelFormat::Id8);
  expect_borrowed(dot::id_view(id16), id16, dot::PixelFormat::Id16);
  expect_borrowed(dot::id_view(id32), id32, dot::PixelFormat::Id32);
}

TEST(OpenCv, RegionOfInterestKeepsTheStrideOfItsParent) {
  const cv::Mat parent(20, 30, CV_8UC3);
  const cv::Mat part = parent(cv::Rect(4, 3, 10, 12));
  expect_borrowed(dot::view(part), part, dot::PixelFormat::Bgr8);
  EXPECT_EQ(dot::view(part).stride, 30 * 3);
}

TEST(OpenCv, EmptyMatGivesEmptyView) {
  EXPECT_TRUE(dot::view(cv::Mat()).empty());
  EXPECT_TRUE(dot::depth_view(cv::Mat()).empty());
  EXPECT_TRUE(dot::id_view(cv::Mat()).empty());
  EXPECT_TRUE(dot::mat(dot::ImageView<float>{}).empty());
}

TEST(OpenCv, OtherTypesAreNamed) {
  EXPECT_EQ(message_of([] { dot::view(cv::Mat(4, 4, CV_16UC1)); }),
            "image is CV_16UC1, must be CV_8UC1, CV_8UC3 or CV_8UC4");
  EXPECT_EQ(message_of([] { dot::depth_view(cv::Mat(4, 4, CV_64FC1)); }),
            "depth is CV_64FC1, must be CV_32FC1 or CV_16UC1");
  EXPECT_EQ(message_of([] { dot::id_view(cv::Mat(4, 4, CV_8UC3)); }),
            "ids is CV_8UC3, must be CV_8UC1, CV_16UC1 or CV_32SC1");
  const int sizes[] = {3, 4, 5};
  EXPECT_EQ(message_of([&] { dot::view(cv::Mat(3, sizes, CV_8UC1)); }),
            "image is not two-dimensional, CV_8UC1, must be CV_8UC1, CV_8UC3 or CV_8UC4");
}

template <typename T>
class MatOfView : public testing::Test {};
using Pixels = testing::Types<std::uint8_t, std::uint16_t, float, std::uint32_t>;
TYPED_TEST_SUITE(MatOfView, Pixels);

TYPED_TEST(MatOfView, SharesTheMemoryBothWays) {
  dot::Image<TypeParam> image(6, 4);
  image.fill(TypeParam{0});
  cv::Mat header = dot::mat(image.view());
  ASSERT_EQ(header.size(), cv::Size(6, 4));
  EXPECT_EQ(header.elemSize(), sizeof(TypeParam));
  *header.ptr<TypeParam>(3, 5) = TypeParam{7};
  EXPECT_EQ(image(5, 3), TypeParam{7});

  const dot::ImageView<const TypeParam> constant = image.view();
  const cv::Mat read_only = dot::mat(constant);
  EXPECT_EQ(read_only.type(), dot::opencv_type<TypeParam>());
  EXPECT_EQ(*read_only.ptr<TypeParam>(3, 5), TypeParam{7});
}

TYPED_TEST(MatOfView, KeepsTheStride) {
  dot::Image<TypeParam> image(8, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) image(x, y) = static_cast<TypeParam>(10 * y + x);
  const dot::ImageView<TypeParam> whole = image.view();
  const dot::ImageView<TypeParam> part{&image(2, 1), 3, 2, whole.stride};
  const cv::Mat header = dot::mat(part);
  EXPECT_EQ(*header.ptr<TypeParam>(0, 0), TypeParam{12});
  EXPECT_EQ(*header.ptr<TypeParam>(1, 2), TypeParam{24});
}

TEST(OpenCv, ResultImagesAreHeadersOverTheResult) {
  dot::Image<std::uint8_t> labels(3, 2);
  dot::Image<std::uint32_t> ids(3, 2);
  labels.fill(2);
  ids.fill(70000);
  const cv::Mat label_mat = dot::to_mat(labels.view());
  const cv::Mat id_mat = dot::to_mat(ids.view());
  EXPECT_EQ(label_mat.data, labels.row(0));
  EXPECT_EQ(label_mat.at<std::uint8_t>(1, 2), 2);
  EXPECT_EQ(id_mat.type(), CV_32SC1);
  EXPECT_EQ(id_mat.at<int>(1, 2), 70000);
}

TEST(OpenCv, StrideBelowARowIsAnError) {
  dot::Image<float> image(8, 4);
  dot::ImageView<float> view = image.view();
  view.stride = 31;
  EXPECT_EQ(message_of([&] { dot::mat(view); }), "view.stride must be at least one row of pixels");
  view.stride = -32;
  EXPECT_EQ(message_of([&] { dot::mat(view); }), "view.stride must be at least one row of pixels");
}

}  // namespace
