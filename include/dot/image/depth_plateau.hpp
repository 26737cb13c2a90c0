// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "dot/abi.hpp"
#include "dot/image/view.hpp"

DOT_BEGIN_NAMESPACE

/// The pixels that have the largest depth of an image, and whether depth seems to be cut off there: by a sensor's
/// range, a simulator's far plane, or a number that stands for holes.
struct DepthPlateau {
  double depth = 0;      ///< metres, the largest that counts as measured; 0: nothing is measured
  double share = 0;      ///< of the pixels looked at
  bool is_flat = false;  ///< seems cut off. So does a wall square to the view, if depth has no noise at all
};

/// Parts of `find_plateau`.
namespace plateaus {

/// Words as they are, floats by their bits, which have the same order unless negative. As whole numbers, because
/// compilers make vector code of comparing these.
inline std::int32_t depth_number(std::uint16_t value) { return value; }
/// The same of metres.
inline std::int32_t depth_number(float value) {
  std::int32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// @param near, far a number between them is a measurement. @param known see below, or `near`. @param slope gives the
/// number of nine tenths of the depth of a number. @return the largest number; `plateau.depth` is not set.
template <typename Value, typename Slope>
std::int32_t find_plateau(const ImageRef& depth, std::int32_t near, std::int32_t far, std::int32_t known, Slope&& slope,
                          DepthPlateau& plateau) {
  constexpr double kLeast = 0.01;     // share of all pixels
  constexpr double kMost = 0.75;      // share of the measured ones
  constexpr double kOverSlope = 1.2;  // over those in the tenth of the depth before it
  constexpr int kLeastRows = 2;       // a level camera sees even ground at the same depth in all of a row
  constexpr double kOverStep = 5;     // over those of the next lower value: coarse depth has about as many
  constexpr int kRows = 32;
  const int step = std::max(1, depth.height / kRows), width = depth.width;
  const int first = std::min(step / 2, depth.height - 1);
  // The sums of a row are local: compilers keep them in registers.
  const auto each_row = [&](auto&& of_row) {
    for (int y = first; y < depth.height; y += step)
      of_row(static_cast<const Value*>(
          static_cast<const void*>(static_cast<const unsigned char*>(depth.data) + y * depth.stride)));
  };
  const auto largest_below = [&](std::int32_t end) {
    std::int32_t largest = near;
    each_row([&](const Value* row) {
      std::int32_t most = near;
      for (int x = 0; x < width; ++x) {
        const std::int32_t v = depth_number(row[x]);
        most = std::max(most, v < end ? v : near);
      }
      largest = std::max(largest, most);
    });
    return largest;
  };
  int rows_hit = 0;  // of the last count
  const auto count = [&](std::int32_t from, std::int32_t to) {
    int total = 0;
    rows_hit = 0;
    each_row([&](const Value* row) {
      int found = 0;
      for (int x = 0; x < width; ++x) {
        const std::int32_t v = depth_number(row[x]);
        found += static_cast<int>(v >= from) & static_cast<int>(v <= to);
      }
      total += found;
      if (found > 0) ++rows_hit;
    });
    return total;
  };

  const std::int32_t top = largest_below(far);
  if (top <= near) return near;
  const int rows = (depth.height - first + step - 1) / step;
  const double pixels = 1.0 * rows * width;
  const int at = count(top, top);
  plateau.share = at / pixels;
  plateau.is_flat = top == known;
  if (top == known || plateau.share < kLeast || rows_hit < kLeastRows) return top;
  const int nearer = count(near + 1, top - 1);
  if (at > kMost * (at + nearer) || at < kOverSlope * count(slope(top), top - 1)) return top;
  const std::int32_t next = largest_below(top);
  const int at_next = count(next, next);
  // Many nearer ones of one value make a scene of flat pictures.
  plateau.is_flat = at >= kOverStep * at_next && nearer >= kOverStep * at_next;
  return top;
}

}  // namespace plateaus

/// Looks at some rows of a depth image as it is given. @param max_depth metres; farther depth counts as not measured.
/// @param known metres, of a plateau that was found before and is flat without another look; 0: none.
inline DepthPlateau find_plateau(const ImageRef& depth, double max_depth, double known = 0) {
  DepthPlateau plateau;
  if (depth.format == PixelFormat::DepthU16) {
    const double unit = depth.depth_units_per_metre;
    const auto number = [](double v) { return static_cast<std::int32_t>(std::min(v, 65535.0)); };
    const std::int32_t near = number(1e-3 * unit);
    const std::int32_t top = plateaus::find_plateau<std::uint16_t>(
        depth, near, number(std::ceil(max_depth * unit)), number(std::round(known * unit)),
        [&](std::int32_t v) { return number(std::ceil(0.9 * v)); }, plateau);
    if (top > near) plateau.depth = top / unit;
  } else {
    const auto number = [](double v) { return plateaus::depth_number(static_cast<float>(v)); };
    const auto metres = [](std::int32_t v) {
      float value;
      std::memcpy(&value, &v, sizeof value);
      return static_cast<double>(value);
    };
    const std::int32_t near = number(1e-3);
    const std::int32_t top = plateaus::find_plateau<float>(
        depth, near, number(max_depth), number(known), [&](std::int32_t v) { return number(0.9 * metres(v)); },
        plateau);
    if (top > near) plateau.depth = metres(top);
  }
  return plateau;
}

DOT_END_NAMESPACE
