// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/moved_points.hpp"
#include "dot/kernel/impl/tukey.hpp"

/// @file
/// The photometric residual of points, its derivatives, and sums of what depends on it, over V::W lanes, see
/// impl/kernels_of.hpp.

namespace dot::kernel {

/// Replaces the gradient (times two) of a sample by that of the reference, or by the mean of both.
/// A small piece of surface appears 1 / Z~ times as large as in the reference, so its gradient is Z~ times as large.
/// Its rotation about the optical axis and its shear are neglected.
template <typename V, GradientSource kGradient, typename Sample>
void take_reference_gradient(const Input& in, const Points& p, int i, const MovedPoints<V>& points, Sample& sample) {
  using F = typename V::F;
  constexpr bool kMean = kGradient == GradientSource::Mean;
  const F scale = V::mul(V::keep(points.seen, points.Z), V::set(kMean ? in.view.gain : 2 * in.view.gain));
  const F gx = V::mul(scale, V::load(p.gu + i)), gy = V::mul(scale, V::load(p.gv + i));
  if constexpr (kMean) {
    const F half = V::set(0.5f);
    sample.gx = V::fma(half, sample.gx, gx), sample.gy = V::fma(half, sample.gy, gy);
  } else {
    sample.gx = gx, sample.gy = gy;
  }
}

/// The photometric residual, see align/photometric_factor.hpp.
template <typename V>
struct Factor {
  using F = typename V::F;
  F intensity;      ///< of the reference
  F r;              ///< grey values
  F gu, gv, along;  ///< dr/dX~ = (gu, gv, -along) / Z
  F dr_dq;          ///< dX~/dq = t
  F extra;          ///< variance besides sigma_I^2

  /// @param sample of the new image. @param reference, sigma_q of the points.
  template <typename Sample>
  Factor(const Constants<V>& c, const MovedPoints<V>& points, const Sample& sample, F reference, F sigma_q)
      : intensity(reference) {
    r = V::sub(V::fma(c.minus_gain, reference, sample.value), c.offset);
    gu = V::mul(sample.gx, c.fx_half), gv = V::mul(sample.gy, c.fy_half);
    along = V::fma(gu, points.xn, V::mul(gv, points.yn));
    dr_dq = V::mul(V::fma(gu, c.t0, V::sub(V::mul(gv, c.t1), V::mul(along, c.t2))), points.iz);
    const F by_depth = V::mul(dr_dq, sigma_q);
    const F gradient = V::fma(sample.gx, sample.gx, V::mul(sample.gy, sample.gy));
    extra = V::fma(by_depth, by_depth, V::mul(c.gradient2, gradient));
  }
};

/// Sums that are accumulated while residuals are computed.
template <typename V>
struct Tally {
  using F = typename V::F;
  F cost = V::set(0);
  F u_min = V::set(1e30f), u_max = V::set(-1e30f), v_min = V::set(1e30f), v_max = V::set(-1e30f);
  F kept = V::set(0), depth_kept = V::set(0);                                      ///< see tukey_kept
  F x = V::set(0), y = V::set(0), xx = V::set(0), xy = V::set(0), yy = V::set(0);  ///< see Moments
  int seen = 0, occluded = 0, with_depth = 0;

  /// Adds to the moments.
  void add_moments(typename V::M is_seen, F reference, F value) {
    const F middle = V::set(128);
    const F before = V::keep(is_seen, V::sub(reference, middle)), now = V::keep(is_seen, V::sub(value, middle));
    x = V::add(x, before), y = V::add(y, now);
    xx = V::fma(before, before, xx), yy = V::fma(now, now, yy);
    xy = V::fma(before, now, xy);
  }

  /// Adds to what is kept of Tukey's cost.
  void add_costs(const Input& in, const Constants<V>& c, typename V::M is_seen, const Factor<V>& f) {
    kept = V::add(kept, V::keep(is_seen, tukey_kept<V>(f.r, V::add(f.extra, c.s2_intensity), in.noise.tukey)));
  }

  /// The same of the depth term.
  void add_depth_costs(const Input& in, const MeasuredDepth<V>& depth) {
    const F of_each = tukey_kept<V>(depth.r, V::set(in.depth->sigma * in.depth->sigma), in.noise.tukey);
    depth_kept = V::add(depth_kept, V::keep(depth.exists, of_each));
    with_depth += V::count(depth.exists);
  }
};

}  // namespace dot::kernel
