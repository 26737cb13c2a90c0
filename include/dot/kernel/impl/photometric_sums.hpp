// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/photometric_pass.hpp"

/// @file
/// The kernels of kernel/photometric.hpp.
///
/// Points are processed in blocks that stay in the first-level cache. First residuals and Jacobians are written as
/// columns. Then products of columns are summed in registers. Lanes whose point is not seen have weight zero. The float
/// sums of a chunk of blocks are added to double sums, in the order of the points.

namespace dot::kernel {

constexpr int kBlocksInAChunk = 8;  // blocks whose sums are float

template <typename V, GradientSource kGradient, bool kDepth>
void all_residuals(const Input& in, const Residuals& out) {
  Tally<V> tally;
  const int n = in.points.n, whole = n / V::W * V::W;
  evaluate<V, kGradient, Wanted::Residuals, kDepth>(in, in.points, whole, &out, nullptr, 0, tally);
  if (whole == n) return;
  Tail<V> tail;
  float f[4][V::W];
  unsigned char bits[V::W];
  const Residuals staged{f[0], f[1], f[2], f[3], bits};
  evaluate<V, kGradient, Wanted::Residuals, kDepth>(in, tail.fill(in.points, whole, n - whole), V::W, &staged, nullptr,
                                                    0, tally);
  for (int i = whole; i < n; ++i) {
    const int lane = i - whole;
    out.r[i] = f[0][lane], out.extra[i] = f[1][lane], out.value[i] = f[2][lane], out.r_depth[i] = f[3][lane];
    out.visibility[i] = bits[lane];
  }
}

template <typename V, GradientSource kGradient>
void residuals_by(const Input& in, const Residuals& out) {
  in.depth ? all_residuals<V, kGradient, true>(in, out) : all_residuals<V, kGradient, false>(in, out);
}

template <typename V>
void residuals(const Input& in, const Residuals& out) {
  if (in.level.width >= 5 && in.level.height >= 5) {
    switch (in.gradient) {
      case GradientSource::Image: return residuals_by<V, GradientSource::Image>(in, out);
      case GradientSource::Reference: return residuals_by<V, GradientSource::Reference>(in, out);
      case GradientSource::Mean: return residuals_by<V, GradientSource::Mean>(in, out);
    }
  }
  for (int i = 0; i < in.points.n; ++i) {  // sampling needs a border
    out.r[i] = out.extra[i] = out.value[i] = out.r_depth[i] = 0;
    out.visibility[i] = 0;
  }
}

/// sums[r][c] += sum_i w c_r c_c over rows [kRow, kRow + kRows), columns [kFirst, kFirst + kCount), c >= r alone.
template <typename V, int kRow, int kRows, int kFirst, int kCount, int kWidth>
void add_products(const float* weight, const float (*column)[kBlock], int n, typename V::F (*sums)[kWidth]) {
  using F = typename V::F;
  F sum[kRows][kCount];
#pragma GCC unroll 8
  for (int r = 0; r < kRows; ++r)
#pragma GCC unroll 8
    for (int c = 0; c < kCount; ++c) sum[r][c] = sums[kRow + r][kFirst + c];
  for (int i = 0; i < n; i += V::W) {
    const F w = V::load(weight + i);
#pragma GCC unroll 8
    for (int r = 0; r < kRows; ++r) {
      const F left = V::mul(w, V::load(column[kRow + r] + i));
#pragma GCC unroll 8
      for (int c = 0; c < kCount; ++c)
        if (kFirst + c >= kRow + r) sum[r][c] = V::fma(left, V::load(column[kFirst + c] + i), sum[r][c]);
    }
  }
#pragma GCC unroll 8
  for (int r = 0; r < kRows; ++r)
#pragma GCC unroll 8
    for (int c = 0; c < kCount; ++c) sums[kRow + r][kFirst + c] = sum[r][c];
}

/// Float sums of a chunk.
template <typename V>
struct Partial {
  typename V::F photo[8][kColumns], depth[3][5];

  Partial() { clear(); }
  void clear() {
    for (auto& row : photo)
      for (auto& sum : row) sum = V::set(0);
    for (auto& row : depth)
      for (auto& sum : row) sum = V::set(0);
  }

  template <bool kDepth>
  void add(const Block& b, int n) {
    // Tiles of about a dozen sums. They fit into the registers and are enough to hide the latency of each sum.
    add_products<V, 0, 2, 0, 6>(b.weight, b.photo, n, photo);
    add_products<V, 2, 4, 2, 4>(b.weight, b.photo, n, photo);
    add_products<V, 0, 4, kReference, 3>(b.weight, b.photo, n, photo);
    add_products<V, 4, 4, kReference, 3>(b.weight, b.photo, n, photo);
    if constexpr (kDepth) {
      add_products<V, 0, 4, kByDepth, 3>(b.weight, b.photo, n, photo);
      add_products<V, 4, 4, kByDepth, 3>(b.weight, b.photo, n, photo);
      add_products<V, 0, 3, 0, 5>(b.depth_weight, b.depth, n, depth);
    }
  }

  /// Adds to `out`; of H only the upper triangle.
  template <bool kDepth>
  void flush(Sums& out) {
    for (int r = 0; r < 8; ++r) {
      for (int c = r; c < 8; ++c) out.H[8 * r + c] += static_cast<double>(V::sum(photo[r][c]));
      out.g[r] += static_cast<double>(V::sum(photo[r][kResidual]));
      if constexpr (kDepth)
        for (int m = 0; m < 3; ++m) out.modes[m][r] += static_cast<double>(V::sum(photo[r][kByDepth + m]));
    }
    if constexpr (kDepth)
      for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) out.H[8 * (2 + r) + 2 + c] += static_cast<double>(V::sum(depth[r][c]));
        out.g[2 + r] += static_cast<double>(V::sum(depth[r][3]));
        out.modes[3][2 + r] += static_cast<double>(V::sum(depth[r][4]));
      }
    clear();
  }
};

/// Converts the linear modes from sums over u and v to modes about the region's middle, scaled by its half extents.
template <typename V>
void centre_modes(const Points& p, const Tally<V>& tally, Sums& out) {
  float bound[4][V::W];
  V::store(bound[0], tally.u_min), V::store(bound[1], tally.u_max);
  V::store(bound[2], tally.v_min), V::store(bound[3], tally.v_max);
  for (int axis = 0; axis < 2; ++axis) {
    float low = bound[2 * axis][0], high = bound[2 * axis + 1][0];
    for (int lane = 1; lane < V::W; ++lane) {
      if (bound[2 * axis][lane] < low) low = bound[2 * axis][lane];
      if (bound[2 * axis + 1][lane] > high) high = bound[2 * axis + 1][lane];
    }
    const float half = 0.5f * (high - low);
    const double extent = half > 1 ? static_cast<double>(half) : 1;
    const double middle = static_cast<double>(0.5f * (low + high)) - static_cast<double>(axis ? p.v[0] : p.u[0]);
    for (int c = 0; c < 8; ++c) out.modes[1 + axis][c] = (out.modes[1 + axis][c] - middle * out.modes[0][c]) / extent;
  }
}

template <typename V, GradientSource kGradient, bool kDepth>
void all_products(const Input& in, Sums& out) {
  Block block;
  for (float& f : block.photo[kMinusOne]) f = -1;
  for (float& f : block.depth[4]) f = 1;
  Tally<V> tally;
  Partial<V> partial;
  const int n = in.points.n;
  for (int start = 0, blocks = 0; start < n; start += kBlock) {
    const int count = n - start < kBlock ? n - start : kBlock, whole = count / V::W * V::W;
    evaluate<V, kGradient, Wanted::Columns, kDepth>(in, advanced<V>(in.points, start), whole, nullptr, &block, 0,
                                                    tally);
    if (whole < count) {
      Tail<V> tail;
      const Points last = tail.fill(in.points, start + whole, count - whole);
      evaluate<V, kGradient, Wanted::Columns, kDepth>(in, last, V::W, nullptr, &block, whole, tally);
    }
    partial.template add<kDepth>(block, (count + V::W - 1) / V::W * V::W);
    if (++blocks == kBlocksInAChunk || start + kBlock >= n) {
      partial.template flush<kDepth>(out);
      out.cost += static_cast<double>(V::sum(tally.cost));
      tally.cost = V::set(0);
      blocks = 0;
    }
  }
  out.seen = tally.seen, out.occluded = tally.occluded;
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < r; ++c) out.H[8 * r + c] = out.H[8 * c + r];
  if constexpr (kDepth) centre_modes<V>(in.points, tally, out);
}

template <typename V, GradientSource kGradient>
void linearize_by(const Input& in, Sums& out) {
  in.depth ? all_products<V, kGradient, true>(in, out) : all_products<V, kGradient, false>(in, out);
}

template <typename V>
void linearize(const Input& in, Sums& out) {
  out = Sums{};
  if (in.points.n <= 0 || in.level.width < 5 || in.level.height < 5) return;  // sampling needs a border
  switch (in.gradient) {
    case GradientSource::Image: return linearize_by<V, GradientSource::Image>(in, out);
    case GradientSource::Reference: return linearize_by<V, GradientSource::Reference>(in, out);
    case GradientSource::Mean: return linearize_by<V, GradientSource::Mean>(in, out);
  }
}

}  // namespace dot::kernel
