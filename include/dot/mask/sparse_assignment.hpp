// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

#include "dot/mask/hungarian.hpp"

DOT_BEGIN_NAMESPACE

/// An allowed pair of a row and a column.
struct PossiblePair {
  int row = 0;      ///< from 0
  int column = 0;   ///< from 0
  double cost = 0;  ///< finite
  int group = 0;    ///< set by `assign`
};

/// Input and buffers of the `assign` below.
struct SparseAssignWorkspace {
  std::vector<PossiblePair> pairs;  ///< to be filled in by the caller; sorted by `assign`
  std::vector<int> partner;         ///< of each row: the result
  std::vector<int> group;           ///< of rows, then columns: a member of the same group
  std::vector<int> columns;         ///< of one group
  std::vector<double> cost;         ///< of one group, row-major
  AssignWorkspace dense;            ///< for one group
};

/// Minimal-cost assignment if few of all pairs are possible. Rows and columns that are not connected by a chain of
/// possible pairs do not influence each other. So each connected group is a small separate problem, and n masks that
/// each overlap a few others take O(n log n) instead of O(n^3).
/// @param absent the cost of a pair that is not in workspace.pairs. It is larger than all costs there. If finite,
/// leaving a row and a column without partners costs so much. If infinite, as many pairs as possible are made.
/// @return the column of each row, or -1; in `workspace`, valid until its next use.
inline const std::vector<int>& assign(int rows, int columns, double absent, SparseAssignWorkspace& workspace) {
  auto& [pairs, partner, group, own_columns, cost, dense] = workspace;
  partner.assign(static_cast<std::size_t>(rows), -1);
  group.resize(static_cast<std::size_t>(rows) + static_cast<std::size_t>(columns));
  std::iota(group.begin(), group.end(), 0);
  const auto root_of = [&groups = group](int i) {
    const auto at = [&groups](int k) -> int& { return groups[static_cast<std::size_t>(k)]; };
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  };
  for (const PossiblePair& p : pairs) group[static_cast<std::size_t>(root_of(p.row))] = root_of(rows + p.column);
  for (PossiblePair& p : pairs) p.group = root_of(p.row);
  std::sort(pairs.begin(), pairs.end(), [](const PossiblePair& a, const PossiblePair& b) {
    return std::tie(a.group, a.row, a.column) < std::tie(b.group, b.row, b.column);
  });

  for (auto first = pairs.begin(), last = first; first != pairs.end(); first = last) {
    own_columns.clear();
    std::size_t n = 0;
    for (last = first; last != pairs.end() && last->group == first->group; ++last) {
      n += last == first || last->row != (last - 1)->row;
      own_columns.push_back(last->column);
    }
    std::sort(own_columns.begin(), own_columns.end());
    own_columns.erase(std::unique(own_columns.begin(), own_columns.end()), own_columns.end());
    const std::size_t m = own_columns.size();
    cost.assign(n * m, absent);
    std::size_t row = 0;
    for (auto p = first; p != last; ++p) {
      row += p != first && p->row != (p - 1)->row;
      const auto column = std::lower_bound(own_columns.begin(), own_columns.end(), p->column) - own_columns.begin();
      cost[row * m + static_cast<std::size_t>(column)] = p->cost;
    }
    const std::vector<int>& found = assign(cost, static_cast<int>(n), static_cast<int>(m), dense);
    row = 0;
    for (auto p = first; p != last; ++p) {
      if (p != first && p->row == (p - 1)->row) continue;
      const int column = found[row];
      if (column >= 0 && cost[row * m + static_cast<std::size_t>(column)] < absent)
        partner[static_cast<std::size_t>(p->row)] = own_columns[static_cast<std::size_t>(column)];
      ++row;
    }
  }
  return partner;
}

DOT_END_NAMESPACE
