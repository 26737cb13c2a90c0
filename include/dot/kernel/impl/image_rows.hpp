// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/images.hpp"

/// @file
/// Rows of images. Those of bytes are plain loops, which become vector code with the flags of their unit. There V is
/// only the unit's name, see impl/kernels_of.hpp.

namespace dot::kernel {

/// Calls body(in + i, out + j) for runs of V::W results. The last results may be computed twice.
/// @param kRows of input; a result uses kTaken values of each.
///
/// A large image is in no cache when it is written. What comes is fetched ahead, also of the next row.
template <typename V, int kRows, int kTaken, typename In, typename Body>
void for_runs(const In* const (&in)[kRows], int n, float* out, Body&& body) {
  constexpr int W = V::W, kAhead = 512;  // results
  const In* at[kRows];
  const auto run = [&](int x) {
    for (int k = 0; k < kRows; ++k) at[k] = in[k] + kTaken * x;
#if defined(__GNUC__)
    __builtin_prefetch(out + x + kAhead, 1);
#endif
    body(at, out + x);
  };
  if (n >= W) {
    for (int x = 0; x + W <= n; x += W) run(x);
    if (n % W) run(n - W);
    return;
  }
  In few[kRows][kTaken * W] = {};
  float results[W];
  for (int k = 0; k < kRows; ++k) {
    for (int i = 0; i < kTaken * n; ++i) few[k][i] = in[k][i];
    at[k] = few[k];
  }
  body(at, results);
  for (int i = 0; i < n; ++i) out[i] = results[i];
}

template <typename V, typename Value>
void invert_depth(const Value* values, int n, const DepthUnits& units, float* out) {
  using F = typename V::F;
  const F unit = V::set(units.unit), near = V::set(units.near), far = V::set(units.far);
  const Value* const rows[1] = {values};
  for_runs<V, 1, 1>(rows, n, out, [&](const Value* const* at, float* to) {
    F value;
    if constexpr (sizeof(Value) == 2)
      value = V::load_words(at[0]);
    else
      value = V::load(at[0]);
    // Values that do not count are divided, too, but not by zero: a host may trap that. `keep` then masks the result.
    V::store(to, V::keep(V::both(V::less(near, value), V::less(value, far)), V::div(unit, V::max(value, near))));
  });
}

template <typename V>
void take_bias(const float* q, int n, const RowBias& bias, float* out) {
  using F = typename V::F;
  const F zero = V::set(0), t = V::set(bias.t), least = V::set(bias.least);
  const float* const rows[3] = {q, bias.base, bias.slope};
  for_runs<V, 3, 1>(rows, n, out, [&](const float* const* at, float* to) {
    const F measured = V::load(at[0]);
    const F without = V::sub(measured, V::fma(V::load(at[2]), t, V::load(at[1])));
    V::store(to, V::keep(V::less(zero, measured), V::max(without, least)));
  });
}

template <typename V>
void halve_depth(const float* upper, const float* lower, int n, float* out) {
  using F = typename V::F;
  const F zero = V::set(0), one = V::set(1), share = V::set(1 - kSameSurface);
  const float* const rows[2] = {upper, lower};
  for_runs<V, 2, 2>(rows, n, out, [&](const float* const* at, float* to) {
    F q[4];
    V::load_pairs(at[0], q[0], q[1]);
    V::load_pairs(at[1], q[2], q[3]);
    const F limit = V::mul(share, V::max(V::max(q[0], q[1]), V::max(q[2], q[3])));
    F sum = zero, count = zero;
    for (const F& each : q) {
      const auto same = V::both(V::less(zero, each), V::not_less(each, limit));
      sum = V::add(sum, V::keep(same, each));
      count = V::add(count, V::keep(same, one));
    }
    V::store(to, V::div(sum, V::max(count, one)));
  });
}

/// First across the rows, without rounding, then along them. Sums of products are up to 2^24. Their high and low bytes
/// are summed separately, so that 16 bits are enough.
template <typename V>
void blur(const unsigned char* const* rows, int n, const BlurWeights& weights, unsigned char* out) {
  using Word = unsigned short;
  constexpr int kRun = 1024;  // pixels at once, so that their sums fit on the stack
  const Word w0 = weights.middle, w1 = weights.next, w2 = weights.outer;
  const unsigned char *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4];
  Word high[kRun + 4], low[kRun + 4];
  for (int begin = 0; begin < n; begin += kRun) {
    const int count = n - begin < kRun ? n - begin : kRun, left = begin - 2;
    const int from = left > 0 ? left : 0, to = begin + count + 2 < n ? begin + count + 2 : n;
    for (int x = from; x < to; ++x) {
      const Word sum = static_cast<Word>(w0 * c[x] + w1 * (b[x] + d[x]) + w2 * (a[x] + e[x]));
      high[x - left] = static_cast<Word>(sum >> 8);
      low[x - left] = static_cast<Word>(sum & 255);
    }
    for (int x = left; x < from; ++x) high[x - left] = high[from - left], low[x - left] = low[from - left];
    for (int x = to; x < begin + count + 2; ++x)
      high[x - left] = high[to - 1 - left], low[x - left] = low[to - 1 - left];
    for (int x = 0; x < count; ++x) {
      const Word h = static_cast<Word>(w0 * high[x + 2] + w1 * static_cast<Word>(high[x + 1] + high[x + 3]) +
                                       w2 * static_cast<Word>(high[x] + high[x + 4]));
      const Word l = static_cast<Word>(w0 * low[x + 2] + w1 * static_cast<Word>(low[x + 1] + low[x + 3]) +
                                       w2 * static_cast<Word>(low[x] + low[x + 4]));
      out[begin + x] = static_cast<unsigned char>(static_cast<Word>(h + (l >> 8) + 128) >> 8);
    }
  }
}

template <typename V>
void halve(const unsigned char* upper, const unsigned char* lower, int n, unsigned char* out) {
  for (int x = 0; x < n; ++x)
    out[x] = static_cast<unsigned char>((upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1] + 2) >> 2);
}

}  // namespace dot::kernel
