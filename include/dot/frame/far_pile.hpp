// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "dot/abi.hpp"
#include "dot/image/depth_plateau.hpp"
#include "dot/image/view.hpp"

DOT_BEGIN_NAMESPACE

/// Finds depth that piles up near its largest value, as that of a network does: it gives the sky, and all that is
/// farther than what it was trained with, about the largest depth that it knows.
///
/// A pile is in the last tenth of the depth. There are many times as many pixels as in the tenth before it; elsewhere
/// depth thins out with the distance. A wall at the far end of the view looks the same, and so does the ground far
/// below. So piles count only from where little is lost with a wall, and not if they are most of the depth. Unlike a
/// plateau (DepthPlateau) a pile has no value that would show it to be one. It need not be found in each frame: it is
/// believed until there is depth beyond it.
class FarPile {
 public:
  /// Takes the next frame into account. @param max_depth metres; farther depth counts as not measured.
  /// @return metres; depth from there on is not measured: the pile's, or infinite.
  double update(const ImageRef& depth, double max_depth) {
    const double unit = depth.depth_units_per_metre;
    const auto word = [unit](double z) { return static_cast<std::int32_t>(std::min(z * unit, 65535.0)); };
    const auto real = [](double z) { return plateaus::depth_number(static_cast<float>(z)); };
    const bool words = depth.format == PixelFormat::DepthU16;
    const Counts now = words ? count<std::uint16_t>(depth, max_depth, word) : count<float>(depth, max_depth, real);
    if (now.top >= kNearest && now.in_pile > kLeast * now.pixels && now.in_pile < kMost * now.measured &&
        now.in_pile > kOverBefore * now.before)
      begin_ = kTenth * now.top;
    else if (now.top > begin_ / (kTenth * kTenth))
      begin_ = 0;
    share_ = begin_ > 0 && now.pixels > 0 ? 1.0 * now.in_pile / now.pixels : 0;
    return begin_ > 0 ? begin_ : std::numeric_limits<double>::infinity();
  }

  /// Share of the last frame's pixels whose depth was left out.
  double share() const { return share_; }

  /// Starts afresh, as at the first frame.
  void forget() noexcept { *this = {}; }

 private:
  static constexpr double kNearest = 40;    ///< metres, of the largest depth
  static constexpr double kLeast = 0.05;    ///< share of the pixels that make a pile
  static constexpr double kMost = 0.75;     ///< and of those with depth
  static constexpr double kOverBefore = 5;  ///< least number of pixels in it, over those before it
  static constexpr double kTenth = 0.9;     ///< where the last tenth of the depth begins
  static constexpr int kRows = 32;          ///< that are looked at

  struct Counts {
    double top = 0;  ///< metres, largest depth
    int pixels = 0, measured = 0, in_pile = 0, before = 0;
  };

  /// @param number gives that of metres, in the order of the image's values.
  template <typename Value, typename Number>
  static Counts count(const ImageRef& depth, double max_depth, Number&& number) {
    const int step = std::max(1, depth.height / kRows);
    const auto each_row = [&](auto&& of_row) {
      for (int y = std::min(step / 2, depth.height - 1); y < depth.height; y += step)
        of_row(static_cast<const Value*>(
            static_cast<const void*>(static_cast<const unsigned char*>(depth.data) + y * depth.stride)));
    };
    const std::int32_t far = number(max_depth);
    std::int32_t top = 0;
    Counts out;
    each_row([&](const Value* row) {
      std::int32_t most = 0;
      for (int x = 0; x < depth.width; ++x) {
        const std::int32_t v = plateaus::depth_number(row[x]);
        most = std::max(most, v < far ? v : 0);
      }
      top = std::max(top, most);
      out.pixels += depth.width;
    });
    out.top = metres_of(depth, top);
    const std::int32_t begin = number(kTenth * out.top), before = number(kTenth * kTenth * out.top);
    each_row([&](const Value* row) {
      int all = 0, later = 0, both = 0;
      for (int x = 0; x < depth.width; ++x) {
        const std::int32_t v = plateaus::depth_number(row[x]);
        all += static_cast<int>(v > 0) & static_cast<int>(v <= top);
        later += static_cast<int>(v >= begin) & static_cast<int>(v <= top);
        both += static_cast<int>(v >= before) & static_cast<int>(v <= top);
      }
      out.measured += all, out.in_pile += later, out.before += both - later;
    });
    return out;
  }

  static double metres_of(const ImageRef& depth, std::int32_t number) {
    if (depth.format == PixelFormat::DepthU16) return number / depth.depth_units_per_metre;
    float value;
    std::memcpy(&value, &number, sizeof value);
    return static_cast<double>(value);
  }

  double begin_ = 0;  ///< of the pile, metres; 0: none
  double share_ = 0;
};

DOT_END_NAMESPACE
