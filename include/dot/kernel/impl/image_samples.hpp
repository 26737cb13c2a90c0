// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/patches.hpp"

/// @file
/// Grey values and gradients at points, over V::W lanes, see impl/kernels_of.hpp.

namespace dot::kernel {

template <typename V>
void sample_run(const Level& level, float scale, const float* u, const float* v, float* value, float* gu, float* gv) {
  using F = typename V::F;
  const F half = V::set(0.5f), to_level = V::set(scale), first = V::set(1);
  const F last_column = V::set(static_cast<float>(level.width) - 2.01f);
  const F last_row = V::set(static_cast<float>(level.height) - 2.01f);
  const auto at_level = [&](const float* at, F last) {
    return V::min(V::max(V::sub(V::mul(V::add(V::load(at), half), to_level), half), first), last);
  };
  const Patch<V> patch(level, at_level(u, last_column), at_level(v, last_row), true);
  V::store(value, patch.value), V::store(gu, V::mul(patch.gx, half)), V::store(gv, V::mul(patch.gy, half));
}

template <typename V>
void sample(const Level& level, float scale, const float* u, const float* v, int n, const Samples& out) {
  constexpr int W = V::W;
  const int whole = n / W * W, rest = n - whole;
  for (int i = 0; i < whole; i += W) sample_run<V>(level, scale, u + i, v + i, out.value + i, out.gu + i, out.gv + i);
  if (!rest) return;
  float last[5][W] = {};
  for (int i = 0; i < rest; ++i) last[0][i] = u[whole + i], last[1][i] = v[whole + i];
  sample_run<V>(level, scale, last[0], last[1], last[2], last[3], last[4]);
  for (int i = 0; i < rest; ++i) {
    out.value[whole + i] = last[2][i];
    out.gu[whole + i] = last[3][i], out.gv[whole + i] = last[4][i];
  }
}

}  // namespace dot::kernel
