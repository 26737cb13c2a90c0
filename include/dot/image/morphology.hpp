// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// The extreme of each square window of 2 kReach + 1 pixels, within the image. `pick` is std::max for a dilation or
/// std::min for an erosion. First along the rows, then across them. Compilers turn loops over a row into SIMD code.
/// @param rows scratch. @param out of the size of `in`; may be `in` itself.
template <int kReach, typename T, typename Pick>
void pick_in_windows(ImageView<const T> in, Pick&& pick, Image<T>& rows, ImageView<T> out) {
  constexpr int kRows = 2 * kReach + 1;  // buffered rows, row y in row y % kRows
  const int width = in.width, height = in.height;
  rows.resize(width, kRows);
  const auto along = [&](const T* from, T* to) {
    const auto at_border = [&](int x) {
      T best = from[x];
      for (int i = std::max(x - kReach, 0); i <= std::min(x + kReach, width - 1); ++i) best = pick(best, from[i]);
      to[x] = best;
    };
    const int inner_end = std::max(width - kReach, kReach);
    for (int x = 0; x < std::min(kReach, width); ++x) at_border(x);
    for (int x = kReach; x < inner_end; ++x) {
      T best = from[x - kReach];
      for (int i = 1 - kReach; i <= kReach; ++i) best = pick(best, from[x + i]);
      to[x] = best;
    }
    for (int x = inner_end; x < width; ++x) at_border(x);
  };
  for (int y = 0, next = 0; y < height; ++y) {
    for (; next <= std::min(y + kReach, height - 1); ++next) along(in.row(next), rows.row(next % kRows));
    const T* from[kRows];  // beyond the border the outermost row is repeated, which changes nothing
    for (int i = 0; i < kRows; ++i) from[i] = rows.row(std::clamp(y + i - kReach, 0, height - 1) % kRows);
    T* to = out.row(y);
    for (int x = 0; x < width; ++x) {
      T best = from[0][x];
      for (int i = 1; i < kRows; ++i) best = pick(best, from[i][x]);
      to[x] = best;
    }
  }
}

/// Sets each pixel to the largest value at most kReach rows and columns away. @param rows scratch.
template <int kReach, typename T>
void dilate(ImageView<const T> in, Image<T>& rows, ImageView<T> out) {
  pick_in_windows<kReach>(
      in, [](T a, T b) { return a > b ? a : b; }, rows, out);
}

/// Sets each pixel to the smallest value at most kReach rows and columns away. @param rows scratch.
template <int kReach, typename T>
void erode(ImageView<const T> in, Image<T>& rows, ImageView<T> out) {
  pick_in_windows<kReach>(
      in, [](T a, T b) { return a < b ? a : b; }, rows, out);
}

DOT_END_NAMESPACE
