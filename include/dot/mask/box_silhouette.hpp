// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
#include "dot/mask/centre.hpp"
#include "dot/mask/fill_unmeasured.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// Cuts the box of a detector to the object in it. The box shows what is beside and behind the object, too. The object
/// is at the distance of the box's middle. What is much nearer or farther, and reaches the border, is not the object's:
/// windows are. Keeps its buffers.
class BoxSilhouette {
 public:
  static constexpr double kFilled = 0.97;  ///< least share of its bounding box that a box fills
  static constexpr int kLeastSide = 8;     ///< pixels: a smaller box is left as it is
  static constexpr double kDeepest = 2;    ///< distance from its middle to its ends, over its size across the view
  static constexpr double kNearer = 0.35;  ///< share of the box's middle that is nearer than where the object is taken
                                           ///< to be: a thin one fills less than half of it, and one before it less
  static constexpr double kLeastShare = 0.1;  ///< of the box: less is not the object, and the box stays as it is

  /// Whether a mask fills its bounding box, as a detector's do.
  static bool is_box(const Mask& mask) {
    return mask.width() >= kLeastSide && mask.height() >= kLeastSide &&
           mask.area >= kFilled * mask.width() * mask.height();
  }

  /// Cuts a box. @param inverse_depth 1/m, of the frame; <= 0: not measured. Such a pixel goes with the nearest one
  /// that is. @param noise pixel_sigma(q) of an inverse depth, 1/m. @param claimed (u, v) -> bool: whether another mask
  /// has the frame's pixel, too, so that it may show another object.
  /// @return whether `mask` has changed. Then its crop is tight again.
  template <typename Camera, typename Noise, typename Claimed>
  bool cut(const Image<float>& inverse_depth, const Camera& camera, const Noise& noise, const Claimed& claimed,
           Mask& mask) {
    const double q = inverse_depth_of_object(inverse_depth, claimed, mask);
    if (!(q > 0)) return false;
    const double focal = 0.5 * (camera.intrinsics().fx + camera.intrinsics().fy);
    const double reach = kDeepest * std::max(mask.width(), mask.height()) / focal;  // over the object's distance
    const double slack = kSigmas * noise.pixel_sigma(q);
    const auto least = static_cast<float>(q / (1 + reach) - slack);
    const auto most = reach < 1 ? static_cast<float>(q / (1 - reach) + slack) : std::numeric_limits<float>::infinity();
    if (!classify(inverse_depth, mask, least, most)) return false;
    fill_unmeasured(kUnmeasured, kinds_, distances_);
    flood_from_border();
    keep_the_rest();
    fill_mask(
        mask.box(), [&](int u, int v) { return mask.at(u, v) && kinds_(u - mask.x, v - mask.y) != 0; }, kept_);
    if (kept_.area < kLeastShare * mask.area || kept_.area == mask.area) return false;
    std::swap(mask, kept_);
    return true;
  }

 private:
  enum Kind : std::uint8_t { kUnmeasured, kObject, kOther, kOutside };
  static constexpr double kSigmas = 4;  ///< of a measurement, that are no difference of depth

  /// Inverse depth of the object, 1/m; 0: not known. That of the box's middle, if other masks leave it, else that of
  /// what they leave, unless that is little: it may be the scene about the object.
  template <typename Claimed>
  double inverse_depth_of_object(const Image<float>& inverse_depth, const Claimed& claimed, const Mask& mask) {
    const auto any = [](int, int) { return true; };
    const auto own = [&](int u, int v) { return !claimed(u, v); };
    const int width = mask.width(), height = mask.height();
    const std::array<int, 4> all{0, 0, width, height};
    const std::array<int, 4> middle{width / 4, height / 4, width - width / 4 * 2, height - height / 4 * 2};
    const int step = sampling_step(mask.area);
    if (!sample(inverse_depth, mask, middle, step, own) && !sample(inverse_depth, mask, all, step, own) &&
        !sample(inverse_depth, mask, middle, step, any))
      return 0;
    const auto count = static_cast<double>(values_.size());
    const auto nth = values_.begin() + static_cast<std::ptrdiff_t>((1 - kNearer) * count);
    std::nth_element(values_.begin(), nth, values_.end());
    return static_cast<double>(*nth);
  }

  /// Sets values_ to the inverse depths in a part (x, y, width, height) of the mask. @return whether there are enough.
  template <typename Condition>
  bool sample(const Image<float>& inverse_depth, const Mask& mask, const std::array<int, 4>& part, int step,
              const Condition& counts) {
    constexpr std::size_t kEnough = 10;
    values_.clear();
    int measured = 0;
    for (int y = part[1]; y < part[1] + part[3]; y += step)
      for (int x = part[0]; x < part[0] + part[2]; x += step) {
        const int u = mask.x + x, v = mask.y + y;
        const float q = inverse_depth(u, v);
        if (!(q > 0) || !mask.pixels(x, y)) continue;
        ++measured;
        if (counts(u, v)) values_.push_back(q);
      }
    return values_.size() >= kEnough && static_cast<double>(values_.size()) >= kLeastShare * measured;
  }

  /// Sets kinds_ by the measurements. @return whether there is something else than the object.
  bool classify(const Image<float>& inverse_depth, const Mask& mask, float least, float most) {
    const int width = mask.width(), height = mask.height();
    kinds_.resize(width, height);
    int others = 0;
    for (int y = 0; y < height; ++y) {
      const float* depth = inverse_depth.row(mask.y + y) + mask.x;
      std::uint8_t* kinds = kinds_.row(y);
      for (int x = 0; x < width; ++x) {
        const bool other = depth[x] < least || depth[x] > most;
        kinds[x] = !(depth[x] > 0) ? kUnmeasured : other ? kOther : kObject;
        others += kinds[x] == kOther;
      }
    }
    return others > 0;
  }

  /// Marks what is not the object's and is connected to the box's border.
  void flood_from_border() {
    const int width = kinds_.width(), height = kinds_.height();
    const auto reach = [&](int x, int y) {
      if (!kinds_.contains(x, y) || kinds_(x, y) != kOther) return;
      kinds_(x, y) = kOutside;
      front_.push_back({x, y});
    };
    for (int x = 0; x < width; ++x) reach(x, 0), reach(x, height - 1);
    for (int y = 0; y < height; ++y) reach(0, y), reach(width - 1, y);
    while (!front_.empty()) {
      const auto [x, y] = front_.back();
      front_.pop_back();
      reach(x - 1, y), reach(x + 1, y), reach(x, y - 1), reach(x, y + 1);
    }
  }

  /// Makes kinds_ non-zero where the object is, without what is less than three pixels wide.
  void keep_the_rest() {
    for (int y = 0; y < kinds_.height(); ++y)
      for (int x = 0; x < kinds_.width(); ++x) kinds_(x, y) = kinds_(x, y) == kOutside ? 0 : 255;
    erode<1>(std::as_const(kinds_).view(), rows_, kinds_.view());
    dilate<1>(std::as_const(kinds_).view(), rows_, kinds_.view());
  }

  std::vector<float> values_;               ///< inverse depths of the box's middle, 1/m
  Image<std::uint8_t> kinds_;               ///< a Kind for each pixel of the box
  Image<int> distances_;                    ///< pixels to the nearest measurement
  std::vector<std::pair<int, int>> front_;  ///< of the flood
  Image<std::uint8_t> rows_;                ///< scratch
  Mask kept_;                               ///< the result, before it is swapped
};

DOT_END_NAMESPACE
