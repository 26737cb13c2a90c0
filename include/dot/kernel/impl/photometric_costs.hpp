// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/photometric_pass.hpp"

/// @file
/// The kernels that compare places: sums over the residuals, which are not stored.

namespace dot::kernel {

/// What is kept of the highest costs, see tukey_kept. Of a chunk of points it is summed in float.
template <typename V>
struct Kept {
  double intensity = 0, depth = 0;

  void move_from(Tally<V>& tally) {
    intensity += static_cast<double>(V::sum(tally.kept));
    depth += static_cast<double>(V::sum(tally.depth_kept));
    tally.kept = tally.depth_kept = V::set(0);
  }
};

template <typename V, GradientSource kGradient, Wanted kWanted, bool kDepth, bool kQuads>
void tally_all(const Input& in, Tally<V>& tally, Kept<V>& kept) {
  constexpr int kChunk = 64 * V::W;
  const int n = in.points.n, whole = n / V::W * V::W;
  for (int start = 0; start < whole; start += kChunk) {
    const int count = whole - start < kChunk ? whole - start : kChunk;
    evaluate<V, kGradient, kWanted, kDepth, kQuads>(in, advanced<V>(in.points, start), count, nullptr, nullptr, 0,
                                                    tally);
    kept.move_from(tally);
  }
  if (whole == n) return;
  Tail<V> tail;
  const Points last = tail.fill(in.points, whole, n - whole);
  evaluate<V, kGradient, kWanted, kDepth, kQuads>(in, last, V::W, nullptr, nullptr, 0, tally);
  kept.move_from(tally);
}

template <typename V, Wanted kWanted, bool kDepth>
void tally_by(const Input& in, Tally<V>& tally, Kept<V>& kept) {
  if (in.level.width < 5 || in.level.height < 5) return;  // sampling needs a border
  switch (in.gradient) {
    case GradientSource::Image:
      return in.level.quads ? tally_all<V, GradientSource::Image, kWanted, kDepth, true>(in, tally, kept)
                            : tally_all<V, GradientSource::Image, kWanted, kDepth, false>(in, tally, kept);
    case GradientSource::Reference:
      return tally_all<V, GradientSource::Reference, kWanted, kDepth, false>(in, tally, kept);
    case GradientSource::Mean: return tally_all<V, GradientSource::Mean, kWanted, kDepth, false>(in, tally, kept);
  }
}

template <typename V>
void costs(const Input& in, Costs& out) {
  Tally<V> tally;
  Kept<V> kept;
  in.depth ? tally_by<V, Wanted::Costs, true>(in, tally, kept) : tally_by<V, Wanted::Costs, false>(in, tally, kept);
  const auto most = static_cast<double>(in.noise.tukey * in.noise.tukey / 6);
  out.sum = most * (tally.seen - kept.intensity);
  if (in.depth && in.depth->weight > 0)
    out.sum += static_cast<double>(in.depth->weight) * most * (tally.with_depth - kept.depth);
  out.seen = tally.seen;
}

/// Without a depth term; no gradient is needed.
template <typename V>
void moments(const Input& in, Moments& out) {
  Tally<V> tally;
  Kept<V> kept;
  if (in.level.width >= 5 && in.level.height >= 5)
    in.level.quads ? tally_all<V, GradientSource::Image, Wanted::Moments, false, true>(in, tally, kept)
                   : tally_all<V, GradientSource::Image, Wanted::Moments, false, false>(in, tally, kept);
  out.seen = tally.seen;
  out.x = V::sum(tally.x), out.y = V::sum(tally.y);
  out.xx = V::sum(tally.xx), out.xy = V::sum(tally.xy), out.yy = V::sum(tally.yy);
}

}  // namespace dot::kernel
