// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "dot/mask/mask.hpp"

namespace dot::test {

/// Checks that the crop is tight, holds 0 and 255 only, and that the area is right.
inline void expect_consistent(const Mask& mask) {
  int area = 0;
  std::vector<int> columns(static_cast<std::size_t>(mask.width())), rows(static_cast<std::size_t>(mask.height()));
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask.pixels(u, v) == 0) continue;
      EXPECT_EQ(mask.pixels(u, v), 255);
      ++columns[static_cast<std::size_t>(u)];
      ++rows[static_cast<std::size_t>(v)];
      ++area;
    }
  }
  EXPECT_EQ(mask.area, area);
  EXPECT_EQ(mask.empty(), area == 0);
  EXPECT_EQ(mask.pixels.empty(), area == 0);
  if (area == 0) return;
  EXPECT_GT(columns.front(), 0);
  EXPECT_GT(columns.back(), 0);
  EXPECT_GT(rows.front(), 0);
  EXPECT_GT(rows.back(), 0);
}

}  // namespace dot::test
