// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "stereo.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace runner {
namespace {

constexpr int subpixels = 16;  // StereoSGBM's disparities are 16 times the pixels

cv::Mat to_grey(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace

StereoDepth::StereoDepth(const dot::Intrinsics& camera) : fx_baseline_(camera.fx * camera.baseline) {
  // About 15 % of the width: with a street camera that reaches down to 2 m.
  disparities_ = std::max(64, subpixels * static_cast<int>(std::lround(0.155 * camera.width / subpixels)));
  constexpr int block = 5;
  constexpr int small_step = 8 * block * block;
  constexpr int large_step = 32 * block * block;
  constexpr int prefilter_cap = 63;
  constexpr int uniqueness_percent = 10;
  matcher_ = cv::StereoSGBM::create(0, disparities_, block, small_step, large_step, -1, prefilter_cap,
                                    uniqueness_percent, 0, 0, cv::StereoSGBM::MODE_SGBM_3WAY);
}

cv::Mat StereoDepth::match(const cv::Mat& left, const cv::Mat& right) {
  // The matcher gives nothing in its first columns, hence a border there.
  cv::Mat wide_left, wide_right, disparity;
  cv::copyMakeBorder(left, wide_left, 0, 0, disparities_, 0, cv::BORDER_REPLICATE);
  cv::copyMakeBorder(right, wide_right, 0, 0, disparities_, 0, cv::BORDER_REPLICATE);
  matcher_->compute(wide_left, wide_right, disparity);
  return disparity.colRange(disparities_, disparity.cols);
}

cv::Mat StereoDepth::compute(const cv::Mat& left, const cv::Mat& right) {
  const cv::Mat grey_left = to_grey(left);
  const cv::Mat grey_right = to_grey(right);
  cv::Mat disparity = match(grey_left, grey_right).clone();

  // The right image's disparities come from the mirrored pair, where right is left.
  cv::Mat mirrored_left, mirrored_right, mirrored;
  cv::flip(grey_left, mirrored_left, 1);
  cv::flip(grey_right, mirrored_right, 1);
  mirrored = match(mirrored_right, mirrored_left);

  constexpr int tolerance = subpixels;
  for (int y = 0; y < disparity.rows; ++y) {
    auto* of_left = disparity.ptr<std::int16_t>(y);
    const auto* of_right = mirrored.ptr<std::int16_t>(y);
    for (int x = 0; x < disparity.cols; ++x) {
      const int partner = x - (of_left[x] + subpixels / 2) / subpixels;
      const bool agrees =
          of_left[x] > 0 && partner >= 0 && std::abs(of_right[disparity.cols - 1 - partner] - of_left[x]) <= tolerance;
      if (!agrees) of_left[x] = 0;
    }
  }
  constexpr int speckle_pixels = 100;
  cv::filterSpeckles(disparity, 0, speckle_pixels, subpixels);

  constexpr int smallest = subpixels / 2;  // below, the depth means nothing
  cv::Mat depth(disparity.size(), CV_32FC1);
  for (int y = 0; y < depth.rows; ++y) {
    const auto* d = disparity.ptr<std::int16_t>(y);
    auto* z = depth.ptr<float>(y);
    for (int x = 0; x < depth.cols; ++x)
      z[x] = d[x] >= smallest ? static_cast<float>(fx_baseline_ * subpixels / d[x]) : 0.0F;
  }
  return depth;
}

}  // namespace runner
