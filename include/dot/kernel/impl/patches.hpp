// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/photometric.hpp"

/// @file
/// Bilinear samples of an image, over V::W lanes, see impl/kernels_of.hpp.

namespace dot::kernel {

/// Bilinear value and, if requested, central differences (times two) of the 4x4 pixels about (u, v).
template <typename V>
struct Patch {
  using F = typename V::F;
  F value, gx = V::set(0), gy = V::set(0);

  static F between(F a, F b, F t) { return V::fma(t, V::sub(b, a), a); }

  /// @pre 1 <= u <= width - 3, 1 <= v <= height - 3.
  Patch(const Level& level, F u, F v, bool gradient) {
    using I = typename V::I;
    const I column = V::to_int(u), row = V::to_int(v);
    const F a = V::sub(u, V::to_float(column)), b = V::sub(v, V::to_float(row));
    const I at = V::addi(V::muli(row, V::seti(static_cast<int>(level.stride))), column);
    // One load gives the four neighbours of a row.
    const unsigned char* corner = level.data - level.stride - 1;
    const I p1 = V::gather4(corner + level.stride, at), p2 = V::gather4(corner + 2 * level.stride, at);
    const F a1 = V::template byte<1>(p1), b1 = V::template byte<2>(p1);
    const F a2 = V::template byte<1>(p2), b2 = V::template byte<2>(p2);
    const F v1 = between(a1, b1, a), v2 = between(a2, b2, a);
    value = between(v1, v2, b);
    if (!gradient) return;
    const I p0 = V::gather4(corner, at), p3 = V::gather4(corner + 3 * level.stride, at);
    const F v0 = between(V::template byte<1>(p0), V::template byte<2>(p0), a);
    const F v3 = between(V::template byte<1>(p3), V::template byte<2>(p3), a);
    gy = between(V::sub(v2, v0), V::sub(v3, v1), b);
    gx = between(between(V::sub(b1, V::template byte<0>(p1)), V::sub(V::template byte<3>(p1), a1), a),
                 between(V::sub(b2, V::template byte<0>(p2)), V::sub(V::template byte<3>(p2), a2), a), b);
  }
};

/// Bilinear value of the 2x2 pixels about (u, v), and its derivatives (times two).
template <typename V>
struct Quad {
  using F = typename V::F;
  F value, gx, gy;

  /// @pre as of Patch.
  Quad(const Level& level, F u, F v) {
    const auto column = V::to_int(u), row = V::to_int(v);
    const F a = V::sub(u, V::to_float(column)), b = V::sub(v, V::to_float(row));
    const auto at = V::muli(V::addi(V::muli(row, V::seti(level.width)), column), V::seti(4));
    const auto pixels = V::gather4(level.quads, at);
    const F a1 = V::template byte<0>(pixels), b1 = V::template byte<1>(pixels);
    const F a2 = V::template byte<2>(pixels), b2 = V::template byte<3>(pixels);
    const F v1 = Patch<V>::between(a1, b1, a), v2 = Patch<V>::between(a2, b2, a), two = V::set(2);
    value = Patch<V>::between(v1, v2, b);
    gx = V::mul(two, Patch<V>::between(V::sub(b1, a1), V::sub(b2, a2), b));
    gy = V::mul(two, V::sub(v2, v1));
  }
};

}  // namespace dot::kernel
