// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "dot/abi.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Gives each pixel with the value `unmeasured` the value of the nearest pixel that has another one, by distances along
/// rows and columns. @param distances scratch.
inline void fill_unmeasured(std::uint8_t unmeasured, Image<std::uint8_t>& kinds, Image<int>& distances) {
  const int width = kinds.width(), height = kinds.height();
  distances.resize(width, height);
  int open = 0;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* kind = kinds.row(y);
    int* distance = distances.row(y);
    for (int x = 0; x < width; ++x) {
      distance[x] = kind[x] == unmeasured ? width + height : 0;
      open += kind[x] == unmeasured;
    }
  }
  if (open == 0) return;
  const auto take = [&](int x, int y, int from_x, int from_y) {
    if (!kinds.contains(from_x, from_y) || distances(from_x, from_y) + 1 >= distances(x, y)) return;
    distances(x, y) = distances(from_x, from_y) + 1;
    kinds(x, y) = kinds(from_x, from_y);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (distances(x, y) > 0) take(x, y, x - 1, y), take(x, y, x, y - 1);
  for (int y = height - 1; y >= 0; --y)
    for (int x = width - 1; x >= 0; --x)
      if (distances(x, y) > 0) take(x, y, x + 1, y), take(x, y, x, y + 1);
}

DOT_END_NAMESPACE
