// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
#include "dot/mask/centre.hpp"
#include "dot/mask/fill_unmeasured.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// Finds the two parts of a mask that may show two things, one behind the other, as a network gives it where they touch
/// in the image. Between the two lies a range of depths, larger than the nearer one, in which the mask has hardly any
/// pixel. Things that are seen through a window or between the spokes of a wheel are no part of their own, nor is a rim
/// of background round the object. Depth that is wrong on a part of one object looks the same: only the motions tell,
/// see `move_apart`. Keeps its buffers.
class DepthGap {
 public:
  static constexpr double kLeastShare = 0.04;  ///< of the mask's pixels with depth, on either side of the gap
  static constexpr double kBetween = 0.02;     ///< of them, that may lie in the gap: depth bleeds at edges
  static constexpr double kDeepest = 0.5;      ///< gap within one thing, over its size across the view
  static constexpr double kLeastWidth = 0.1;   ///< mean width of a part, over the side of a square of the mask's area
  static constexpr double kLeastOutside =
      0.25;                               ///< of the farther part's outline, that the nearer one does not enclose
  static constexpr int kLeastArea = 100;  ///< pixels of a part

  /// Finds the parts of a mask. @param inverse_depth 1/m, of the frame; <= 0: not measured. Such a pixel goes with the
  /// nearest one that is. @param noise pixel_sigma(q) of an inverse depth, 1/m. @return whether there are two.
  template <typename Camera, typename Noise>
  bool find(const Image<float>& inverse_depth, const Camera& camera, const Noise& noise, const Mask& mask, Mask& near,
            Mask& far) {
    if (mask.area < 2 * kLeastArea || !find_gap(inverse_depth, mask)) return false;
    const double focal = 0.5 * (camera.intrinsics().fx + camera.intrinsics().fy);
    const double q = static_cast<double>(far_q_), gap = 1 / q - 1 / static_cast<double>(near_q_);
    const double slack = kSigmas * noise.pixel_sigma(q) / (q * q);
    const auto most = [&](double pixels) { return kDeepest * pixels / (focal * static_cast<double>(near_q_)) + slack; };
    if (gap < most(std::sqrt(kLeastShare * mask.area))) return false;

    classify(inverse_depth, mask);
    const Part nearer = part(mask, kNear, opened_), farther = part(mask, kFar, opened_);
    const double least_width = kLeastWidth * std::sqrt(mask.area);
    for (const Part& p : {nearer, farther})
      if (p.area < std::max<double>(kLeastArea, kLeastShare * mask.area) || p.width() < least_width) return false;
    if (farther.outside < kLeastOutside * farther.outline || gap < most(nearer.extent)) return false;

    const auto is = [&](Kind kind) {
      return [this, &mask, kind](int u, int v) { return mask.at(u, v) && kinds_(u - mask.x, v - mask.y) == kind; };
    };
    fill_mask(mask.box(), is(kNear), near);
    fill_mask(mask.box(), is(kFar), far);
    return true;
  }

 private:
  enum Kind : std::uint8_t { kUnmeasured, kNear, kFar };
  static constexpr double kSigmas = 4;  ///< of a measurement, that are no difference of depth

  struct Part {
    int area = 0;     ///< pixels, without what is less than five pixels wide
    int outline = 0;  ///< sides of its pixels, towards others
    int outside = 0;  ///< those of them that are the mask's outline
    int extent = 0;   ///< pixels, the longer side of its bounding box

    double width() const { return 2.0 * area / std::max(1, outline); }
  };

  /// Finds the largest ratio of inverse depths with few samples between.
  bool find_gap(const Image<float>& inverse_depth, const Mask& mask) {
    constexpr std::size_t kEnough = 40;
    values_.clear();
    const int step = sampling_step(mask.area);
    for (int y = 0; y < mask.height(); y += step)
      for (int x = 0; x < mask.width(); x += step) {
        const float q = inverse_depth(mask.x + x, mask.y + y);
        if (mask.pixels(x, y) && q > 0) values_.push_back(q);
      }
    if (values_.size() < kEnough) return false;
    std::sort(values_.begin(), values_.end());
    const auto count = static_cast<double>(values_.size());
    const auto least = static_cast<std::size_t>(kLeastShare * count), few = static_cast<std::size_t>(kBetween * count);
    float largest = 1;
    for (std::size_t i = least; i + 1 + few + least < values_.size(); ++i) {
      const float ratio = values_[i + 1 + few] / values_[i];
      if (ratio <= largest) continue;
      largest = ratio;
      far_q_ = values_[i];
      near_q_ = values_[i + 1 + few];
    }
    return largest > 1;
  }

  void classify(const Image<float>& inverse_depth, const Mask& mask) {
    const float border = 0.5f * (near_q_ + far_q_);
    kinds_.resize(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); ++y)
      for (int x = 0; x < mask.width(); ++x) {
        const float q = inverse_depth(mask.x + x, mask.y + y);
        kinds_(x, y) = !(q > 0) ? kUnmeasured : q > border ? kNear : kFar;
      }
    fill_unmeasured(kUnmeasured, kinds_, distances_);
  }

  /// The pixels of the mask of one kind, without what is narrow.
  Part part(const Mask& mask, Kind kind, Image<std::uint8_t>& pixels) {
    const int width = mask.width(), height = mask.height();
    pixels.resize(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) pixels(x, y) = mask.pixels(x, y) && kinds_(x, y) == kind ? 255 : 0;
    erode<2>(std::as_const(pixels).view(), rows_, pixels.view());
    dilate<2>(std::as_const(pixels).view(), rows_, pixels.view());
    Part out;
    int left = width, right = -1, top = height, bottom = -1;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (!pixels(x, y)) continue;
        ++out.area;
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        for (const auto& [u, v] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
          const bool inside = pixels.contains(u, v);
          out.outline += !inside || !pixels(u, v);
          out.outside += !inside || !mask.pixels(u, v);
        }
      }
    out.extent = std::max(right - left, bottom - top) + 1;
    return out;
  }

  float near_q_ = 0, far_q_ = 0;  ///< inverse depth of both ends of the gap, 1/m
  std::vector<float> values_;     ///< inverse depths of the mask, 1/m
  Image<std::uint8_t> kinds_;     ///< a Kind for each pixel of the crop
  Image<std::uint8_t> opened_;    ///< pixels of a part, without what is narrow
  Image<int> distances_;          ///< scratch
  Image<std::uint8_t> rows_;      ///< scratch
};

DOT_END_NAMESPACE
