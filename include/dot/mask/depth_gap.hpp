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
    // The nearer part is about as long as a square of its share of the area, at least.
    if (gap < most(kOfSquare * std::sqrt(near_share_ * mask.area))) return false;

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
  static constexpr double kOfSquare = 0.9;  ///< less, as samples and pixels differ
  static constexpr double kSigmas = 4;      ///< of a measurement, that are no difference of depth

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
      near_share_ = 1 - static_cast<double>(i + 1 + few) / count;
    }
    return largest > 1;
  }

  void classify(const Image<float>& inverse_depth, const Mask& mask) {
    const float border = 0.5f * (near_q_ + far_q_);
    kinds_.resize(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); ++y) {
      const float* q = inverse_depth.row(mask.y + y) + mask.x;
      std::uint8_t* kind = kinds_.row(y);
      for (int x = 0; x < mask.width(); ++x) kind[x] = !(q[x] > 0) ? kUnmeasured : q[x] > border ? kNear : kFar;
    }
    fill_unmeasured(kUnmeasured, kinds_, distances_);
  }

  /// The pixels of the mask of one kind, without what is narrow.
  Part part(const Mask& mask, Kind kind, Image<std::uint8_t>& pixels) {
    const int width = mask.width(), height = mask.height();
    pixels.resize(width, height);
    for (int y = 0; y < height; ++y) {
      const std::uint8_t *set = mask.pixels.row(y), *is = kinds_.row(y);
      std::uint8_t* row = pixels.row(y);
      for (int x = 0; x < width; ++x) row[x] = is[x] == kind ? set[x] : 0;
    }
    erode<2>(std::as_const(pixels).view(), rows_, pixels.view());
    dilate<2>(std::as_const(pixels).view(), rows_, pixels.view());
    Part out;
    // Sides between two pixels of which one is the part's, or one is the part's and the other is not the mask's.
    nothing_.assign(static_cast<std::size_t>(width), 0);
    const auto count_sides = [&out](const std::uint8_t* a, const std::uint8_t* a_mask, const std::uint8_t* b,
                                    const std::uint8_t* b_mask, int n) {
      int outline = 0, outside = 0;
      for (int i = 0; i < n; ++i) {
        outline += (a[i] ^ b[i]) & 1;
        outside += ((a[i] & ~b_mask[i]) | (b[i] & ~a_mask[i])) & 1;
      }
      out.outline += outline, out.outside += outside;
    };
    const std::uint8_t *above = nothing_.data(), *mask_above = nothing_.data();
    for (int y = 0; y < height; ++y) {
      const std::uint8_t *row = pixels.row(y), *mask_row = mask.pixels.row(y);
      for (int x = 0; x < width; ++x) out.area += row[x] & 1;
      const int at_border = (row[0] & 1) + (row[width - 1] & 1);
      out.outline += at_border, out.outside += at_border;
      count_sides(row, mask_row, row + 1, mask_row + 1, width - 1);
      count_sides(row, mask_row, above, mask_above, width);
      above = row, mask_above = mask_row;
    }
    count_sides(above, mask_above, nothing_.data(), nothing_.data(), width);
    const std::array<int, 4> box = crop_by_rows(
        {0, 0, width, height}, [&](int y) { return [row = pixels.row(y)](int x) { return row[x] != 0; }; });
    out.extent = std::max(box[2], box[3]);
    return out;
  }

  float near_q_ = 0, far_q_ = 0;       ///< inverse depth of both ends of the gap, 1/m
  double near_share_ = 0;              ///< of the samples, nearer than the gap
  std::vector<float> values_;          ///< inverse depths of the mask, 1/m
  Image<std::uint8_t> kinds_;          ///< a Kind for each pixel of the crop
  Image<std::uint8_t> opened_;         ///< pixels of a part, without what is narrow
  std::vector<std::uint8_t> nothing_;  ///< a row without pixels
  Image<int> distances_;               ///< scratch
  Image<std::uint8_t> rows_;           ///< scratch
};

DOT_END_NAMESPACE
