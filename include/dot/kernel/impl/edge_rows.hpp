// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/edges.hpp"

/// @file
/// Plain loops over 16-bit numbers, which become vector code with the flags of their unit. V is only the unit's name,
/// see impl/kernels_of.hpp.

namespace dot::kernel {

namespace edge_rows {

template <typename V>
short difference(unsigned char a, unsigned char b) {
  return static_cast<short>(a - b);
}

template <typename V>
short magnitude(short a) {
  const auto minus = static_cast<short>(-a);
  return a > minus ? a : minus;
}

// Pointers to results are parameters, because only those are known not to alias.

template <typename V>
void compare_row(const unsigned char* a0, const unsigned char* a1, const unsigned char* a2, const unsigned char* b0,
                 const unsigned char* b1, const unsigned char* b2, int n, unsigned short* __restrict part,
                 unsigned short* __restrict all) {
  for (int x = 0; x < n; ++x) {
    const short ax = difference<V>(a1[x + 1], a1[x - 1]), ay = difference<V>(a2[x], a0[x]);
    const short bx = difference<V>(b1[x + 1], b1[x - 1]), by = difference<V>(b2[x], b0[x]);
    const auto dx = static_cast<short>(ax - bx), dy = static_cast<short>(ay - by);
    part[x] = static_cast<unsigned short>(part[x] + magnitude<V>(dx) + magnitude<V>(dy));
    all[x] =
        static_cast<unsigned short>(all[x] + magnitude<V>(ax) + magnitude<V>(ay) + magnitude<V>(bx) + magnitude<V>(by));
  }
}

template <typename V>
void sum_row(const unsigned char* above, const unsigned char* here, const unsigned char* below, int n, short fade,
             short edge, short* __restrict x_sums, short* __restrict y_sums, short* __restrict lengths,
             unsigned short* __restrict part, unsigned short* __restrict all, unsigned char* __restrict stays) {
  constexpr short kMostLost = 3000;  // ten times as much is beyond any length, and fits
  const auto faded = [fade](short a) { return static_cast<short>(a - static_cast<short>((a * fade) >> 16)); };
  for (int i = 0; i < n; ++i) {
    const auto gx = static_cast<short>(kEdgeUnit * difference<V>(here[i + 1], here[i - 1]));
    const auto gy = static_cast<short>(kEdgeUnit * difference<V>(below[i], above[i]));
    const auto x = static_cast<short>(faded(x_sums[i]) + gx), y = static_cast<short>(faded(y_sums[i]) + gy);
    const auto length = static_cast<short>(faded(lengths[i]) + magnitude<V>(gx) + magnitude<V>(gy));
    x_sums[i] = x, y_sums[i] = y, lengths[i] = length;
    const auto is_edge = static_cast<short>(length > edge ? -1 : 0);
    const auto sum = static_cast<short>(magnitude<V>(x) + magnitude<V>(y));
    part[i] = static_cast<unsigned short>(part[i] + (sum & is_edge));
    all[i] = static_cast<unsigned short>(all[i] + (length & is_edge));
    // sum > .9 length
    const auto lost = static_cast<short>(length - sum);
    const auto tenfold = static_cast<short>(10 * (lost < kMostLost ? lost : kMostLost));
    const auto remains = static_cast<short>(tenfold < length ? 1 : 0);
    stays[i] = static_cast<unsigned char>(remains & is_edge);
  }
}

}  // namespace edge_rows

template <typename V>
void compare_edges(const ThreeRows& now, const ThreeRows& before, int n, const EdgeColumns& columns) {
  edge_rows::compare_row<V>(now.above, now.here, now.below, before.above, before.here, before.below, n, columns.part,
                            columns.all);
}

template <typename V>
void sum_edges(const ThreeRows& rows, int n, const EdgeSums& sums, const EdgeColumns& columns, unsigned char* stays) {
  edge_rows::sum_row<V>(rows.above, rows.here, rows.below, n, sums.fade, sums.edge, sums.x, sums.y, sums.length,
                        columns.part, columns.all, stays);
}

}  // namespace dot::kernel
