// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// Votes for one of two motions, by the cells of a grid over the image. A cell votes for the motion that explains its
/// points clearly better. A sum over all points counts texture: a lorry with lettering has more of it than a road.
/// Cells count area.
struct CellVotes {
  static constexpr int kColumns = 16;      ///< of cells in the image
  static constexpr int kRows = 8;          ///< of cells in the image
  static constexpr int kMinPoints = 4;     ///< of a cell that may vote
  static constexpr float kClearly = 0.6f;  ///< share of the other motion's cost

  /// A value for each cell, row by row: mean inverse depth of its points, 1/m, or 0.
  using Depths = std::array<float, kColumns * kRows>;

  int first = 0;      ///< cells that voted for the first motion
  int second = 0;     ///< cells that voted for the second motion
  Depths first_q{};   ///< of the cells that voted for the first motion
  Depths second_q{};  ///< of the cells that voted for the second motion

  /// Adds the votes of some points. @param cost_first, cost_second of each point; negative where it is not seen.
  void add(const PointSet& points, const std::vector<float>& cost_first, const std::vector<float>& cost_second,
           int width, int height) {
    struct Cell {
      int count = 0;
      float first = 0, second = 0, q = 0;
    };
    std::array<Cell, kColumns * kRows> cells{};
    for (std::size_t i = 0; i < cost_first.size(); ++i) {
      if (cost_first[i] < 0 || cost_second[i] < 0) continue;
      Cell& cell = cells[cell_of(points, i, width, height)];
      ++cell.count, cell.first += cost_first[i], cell.second += cost_second[i], cell.q += points.q[i];
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const Cell& cell = cells[k];
      if (cell.count < kMinPoints) continue;
      const float q = cell.q / static_cast<float>(cell.count);
      if (cell.first < kClearly * cell.second) ++first, first_q[k] = q;
      if (cell.second < kClearly * cell.first) ++second, second_q[k] = q;
    }
  }

  /// The cell of a point.
  static std::size_t cell_of(const PointSet& points, std::size_t i, int width, int height) {
    const int x = std::clamp(static_cast<int>(points.u[i]) * kColumns / width, 0, kColumns - 1);
    const int y = std::clamp(static_cast<int>(points.v[i]) * kRows / height, 0, kRows - 1);
    const int index = y * kColumns + x;
    return static_cast<std::size_t>(index);
  }
};

DOT_END_NAMESPACE
