// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/patches.hpp"
#include "dot/kernel/impl/photometric_columns.hpp"

/// @file
/// One pass over points: from their coordinates to what a kernel wants of their residuals, over V::W lanes, see
/// impl/kernels_of.hpp.

namespace dot::kernel {

/// What `evaluate` computes of each point: residuals, columns of a block, or sums in the tally.
enum class Wanted { Residuals, Columns, Costs, Moments };

/// Computes residuals of the first `n` points of `p`, a multiple of the lanes. Writes them to `out`, or as columns of
/// `block` from index `at` on, or adds to `tally`. @tparam kQuads whether `in.level.quads` are read; only for
/// GradientSource::Image.
///
/// The steps must be inlined, so that vectors stay in registers from one to the next.
template <typename V, GradientSource kGradient, Wanted kWanted, bool kDepth, bool kQuads = false>
[[gnu::flatten]] void evaluate(const Input& in, const Points& p, int n, const Residuals* out, Block* block, int at,
                               Tally<V>& tally) {
  using F = typename V::F;
  const Constants<V> c(in);
  for (int i = 0; i < n; i += V::W) {
    MovedPoints<V> points(c, p, i);
    const auto depth = [&] {
      if constexpr (kDepth)
        return MeasuredDepth<V>(*in.depth, points);
      else
        return MeasuredDepth<V>();
    }();
    if constexpr (kDepth) tally.occluded += V::count(depth.occluded);
    tally.seen += V::count(points.seen);

    auto sample = [&] {
      if constexpr (kQuads)
        return Quad<V>(in.level, points.u, points.v);
      else
        return Patch<V>(in.level, points.u, points.v,
                        kGradient != GradientSource::Reference && kWanted != Wanted::Moments);
    }();
    const F intensity = V::load(p.intensity + i);
    if constexpr (kWanted == Wanted::Moments) {
      tally.add_moments(points.seen, intensity, sample.value);
      continue;
    }
    if constexpr (kGradient != GradientSource::Image) take_reference_gradient<V, kGradient>(in, p, i, points, sample);
    const Factor<V> factor(c, points, sample, intensity, V::load(p.sigma_q + i));

    if constexpr (kWanted == Wanted::Costs) {
      tally.add_costs(in, c, points.seen, factor);
      if constexpr (kDepth) tally.add_depth_costs(in, depth);
    } else if constexpr (kWanted == Wanted::Columns) {
      const Arms<V> arms(c, points);
      store_columns(c, points, arms, factor, *block, at + i, tally);
      if constexpr (kDepth) {
        store_modes(in, p, i, factor, *block, at + i, tally);
        store_depth_columns(in, c, points, arms, depth, *block, at + i, tally);
      }
    } else {
      V::store(out->r + i, V::keep(points.seen, factor.r));
      V::store(out->extra + i, V::keep(points.seen, factor.extra));
      V::store(out->value + i, V::keep(points.seen, sample.value));
      V::store(out->r_depth + i, depth.r);
      V::store_bits(out->visibility + i, points.seen, depth.exists, depth.occluded);
    }
  }
}

/// The last points of a set, fewer than the lanes. Excluded copies of the last point fill the other lanes.
template <typename V>
struct Tail {
  float f[9][V::W];
  unsigned char excluded[V::W];

  /// Points from..from + count of `p`. The result borrows the memory of this object.
  Points fill(const Points& p, int from, int count) {
    const float* const arrays[9] = {p.x, p.y, p.q, p.sigma_q, p.intensity, p.gu, p.gv, p.u, p.v};
    for (int lane = 0; lane < V::W; ++lane) {
      const int i = from + (lane < count ? lane : count - 1);
      for (int k = 0; k < 9; ++k) f[k][lane] = arrays[k] ? arrays[k][i] : 0;
      excluded[lane] = lane >= count || (p.excluded && p.excluded[i]);
    }
    return {V::W, f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], excluded};
  }
};

/// `p` from point `i` on.
template <typename V>
Points advanced(Points p, int i) {
  p.n -= i;
  const float** const arrays[9] = {&p.x, &p.y, &p.q, &p.sigma_q, &p.intensity, &p.gu, &p.gv, &p.u, &p.v};
  for (const float** a : arrays)
    if (*a) *a += i;
  if (p.excluded) p.excluded += i;
  return p;
}

}  // namespace dot::kernel
