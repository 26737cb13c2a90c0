// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "dot/abi.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of `assign`.
struct AssignWorkspace {
  std::vector<int> column;    ///< of each row: the result
  std::vector<double> u;      ///< potentials of the rows
  std::vector<double> v;      ///< potentials of the columns
  std::vector<double> slack;  ///< least reduced cost of each column
  std::vector<int> row_of;    ///< row of each column
  std::vector<int> previous;  ///< column before each column on the augmenting path
  std::vector<char> done;     ///< columns of the path's tree
};

namespace hungarian {

/// Gives a row a column, by the shortest augmenting path: rows on it that have a column get another one. Columns are
/// numbered from 1: column 0 stands for the row that is being placed.
/// @param cost (row, column from 0) -> cost.
template <typename Cost>
void place_row(int placed, const Cost& cost, AssignWorkspace& workspace) {
  auto& [column, u, v, slack, row_of, previous, done] = workspace;
  const std::size_t size = v.size();
  slack.assign(size, std::numeric_limits<double>::infinity());
  done.assign(size, 0);
  row_of[0] = placed;
  std::size_t here = 0;
  do {
    done[here] = 1;
    const int row = row_of[here];
    double step = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t j = 1; j < size; ++j) {
      if (done[j]) continue;
      const double reduced = cost(row, static_cast<int>(j) - 1) - u[static_cast<std::size_t>(row)] - v[j];
      if (reduced < slack[j]) {
        slack[j] = reduced;
        previous[j] = static_cast<int>(here);
      }
      if (slack[j] < step) {
        step = slack[j];
        next = j;
      }
    }
    for (std::size_t j = 0; j < size; ++j) {
      if (done[j]) {
        u[static_cast<std::size_t>(row_of[j])] += step;
        v[j] -= step;
      } else {
        slack[j] -= step;
      }
    }
    here = next;
  } while (row_of[here] >= 0);
  while (here != 0) {
    const auto from = static_cast<std::size_t>(previous[here]);
    row_of[here] = row_of[from];
    here = from;
  }
}

}  // namespace hungarian

/// Minimal-cost assignment (Hungarian method with potentials and shortest augmenting paths; Kuhn 1955, Jonker and
/// Volgenant 1987), O(min^2 max) of rows and columns.
/// @param cost row-major, rows x cols; a pair whose cost is not finite is forbidden.
/// @return the column of each row, or -1; in `workspace`, valid until its next use. As many pairs as possible are made;
/// among those, the cheapest set.
/// @throws std::invalid_argument if `cost` has another size.
inline std::vector<int>& assign(const std::vector<double>& cost, int rows, int cols, AssignWorkspace& workspace) {
  if (rows < 0 || cols < 0 || cost.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols))
    throw std::invalid_argument("cost must have rows * cols elements");
  auto& [column, u, v, slack, row_of, previous, done] = workspace;
  column.assign(static_cast<std::size_t>(rows), -1);
  if (cost.empty()) return column;

  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double c : cost) {
    if (!std::isfinite(c)) continue;
    low = std::min(low, c);
    high = std::max(high, c);
  }
  if (low > high) return column;

  // A forbidden pair costs more than any rearrangement of the allowed pairs can save.
  const int n = std::min(rows, cols), m = std::max(rows, cols);
  const double forbidden = (n + 1) * (high - low) + 1;
  const bool transposed = rows > cols;
  const auto index = [&](int i, int j) {
    return static_cast<std::size_t>(transposed ? j : i) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(transposed ? i : j);
  };
  const auto at = [&](int i, int j) {
    const double c = cost[index(i, j)];
    return std::isfinite(c) ? c - low : forbidden;
  };

  const auto size = static_cast<std::size_t>(m) + 1;  // see place_row
  u.assign(static_cast<std::size_t>(n), 0);
  v.assign(size, 0);
  row_of.assign(size, -1);
  previous.resize(size);
  for (int i = 0; i < n; ++i) hungarian::place_row(i, at, workspace);

  for (int j = 0; j < m; ++j) {
    const int i = row_of[static_cast<std::size_t>(j) + 1];
    if (i < 0 || !std::isfinite(cost[index(i, j)])) continue;
    column[static_cast<std::size_t>(transposed ? j : i)] = transposed ? i : j;
  }
  return column;
}

DOT_END_NAMESPACE
