// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/patches.hpp"
#include "dot/kernel/impl/tukey.hpp"

/// @file
/// Residuals and Jacobians of blocks of points over a vector of V::W lanes, see impl/kernels_of.hpp.
/// impl/photometric_sums.hpp sums them.

namespace dot::kernel {

constexpr int kBlock = 128;    // points
constexpr int kReference = 6;  // columns: 0 to 5 of the pose, 6 minus the reference's intensity (of the gain)
constexpr int kMinusOne = 7;   // minus one (of the offset)
constexpr int kResidual = 8;   // the residual
constexpr int kByDepth = 9;    // its derivative by inverse depth, times 1, u and v
constexpr int kColumns = 12;

/// The columns of one block.
struct Block {
  alignas(64) float photo[kColumns][kBlock];
  alignas(64) float weight[kBlock];
  alignas(64) float depth[5][kBlock];  ///< of the depth residual: derivatives by the shift along z and the turns about
                                       ///< x and y, the residual, one
  alignas(64) float depth_weight[kBlock];
};

/// Sums that are accumulated while residuals are computed.
template <typename V>
struct Tally {
  typename V::F cost = V::set(0);
  typename V::F u_min = V::set(1e30f), u_max = V::set(-1e30f), v_min = V::set(1e30f), v_max = V::set(-1e30f);
  typename V::F kept = V::set(0), depth_kept = V::set(0);                                      ///< see tukey_kept
  typename V::F x = V::set(0), y = V::set(0), xx = V::set(0), xy = V::set(0), yy = V::set(0);  ///< see Moments
  int seen = 0, occluded = 0, with_depth = 0;
};

/// What `evaluate` computes of each point: residuals, columns of a block, or sums in the tally.
enum class Wanted { Residuals, Columns, Costs, Moments };

/// Computes residuals of the first `n` points of `p`, a multiple of the lanes. Writes them to `out`, or as columns of
/// `block` from index `at` on, or adds to `tally`. @tparam kQuads whether `in.level.quads` are read; only for
/// GradientSource::Image.
template <typename V, GradientSource kGradient, Wanted kWanted, bool kDepth, bool kQuads = false>
void evaluate(const Input& in, const Points& p, int n, const Residuals* out, Block* block, int at, Tally<V>& tally) {
  using F = typename V::F;
  using M = typename V::M;
  const View& view = in.view;
  const F R0 = V::set(view.R[0]), R1 = V::set(view.R[1]), R2 = V::set(view.R[2]), R3 = V::set(view.R[3]);
  const F R4 = V::set(view.R[4]), R5 = V::set(view.R[5]), R6 = V::set(view.R[6]), R7 = V::set(view.R[7]);
  const F R8 = V::set(view.R[8]), t0 = V::set(view.t[0]), t1 = V::set(view.t[1]), t2 = V::set(view.t[2]);
  const F c0 = V::set(-view.centre[0]), c1 = V::set(-view.centre[1]), c2 = V::set(-view.centre[2]);
  const F fx = V::set(view.fx), fy = V::set(view.fy), cx = V::set(view.cx), cy = V::set(view.cy);
  const F fx_half = V::set(0.5f * view.fx), fy_half = V::set(0.5f * view.fy);
  const F zero = V::set(0), one = V::set(1), z_min = V::set(1e-3f);
  const F u_end = V::set(static_cast<float>(in.level.width - 3)),
          v_end = V::set(static_cast<float>(in.level.height - 3));
  const F minus_gain = V::set(-view.gain), offset = V::set(view.offset);
  const F s2_intensity = V::set(in.noise.s2), gradient2 = V::set(0.25f * in.noise.gradient2);
  const F huber = V::set(in.noise.huber), half = V::set(0.5f);

  for (int i = 0; i < n; i += V::W) {
    const F x = V::load(p.x + i), y = V::load(p.y + i), q = V::load(p.q + i);
    const F X = V::fma(R0, x, V::fma(R1, y, V::fma(t0, q, R2)));
    const F Y = V::fma(R3, x, V::fma(R4, y, V::fma(t1, q, R5)));
    const F Z = V::fma(R6, x, V::fma(R7, y, V::fma(t2, q, R8)));
    F iz = V::div(one, Z), xn = V::mul(X, iz), yn = V::mul(Y, iz);
    F u = V::fma(fx, xn, cx), v = V::fma(fy, yn, cy);
    M seen = V::both(V::not_less(Z, z_min), V::both(V::both(V::not_less(u, one), V::less(u, u_end)),
                                                    V::both(V::not_less(v, one), V::less(v, v_end))));
    if (p.excluded) seen = V::both(seen, V::zero_bytes(p.excluded + i));
    // Values of the other lanes, which may be infinite or NaN, must not reach an address or a sum.
    u = V::min(V::max(u, one), u_end), v = V::min(V::max(v, one), v_end);
    xn = V::keep(seen, xn), yn = V::keep(seen, yn), iz = V::keep(seen, iz);
    const F qi = V::keep(seen, V::mul(q, iz));

    M has_depth = V::less(one, zero), occluded = has_depth;
    F r_depth = zero;
    if constexpr (kDepth) {
      const Depth& d = *in.depth;
      const F left = V::add(u, half), top = V::add(v, half), scale = V::set(d.scale);
      const F ud = V::mul(left, scale), vd = V::mul(top, scale);
      const M inside = V::both(seen, V::both(V::less(ud, V::set(static_cast<float>(d.width))),
                                             V::less(vd, V::set(static_cast<float>(d.height)))));
      const auto column = V::mini(V::to_int(ud), V::seti(d.width - 1));
      const auto row = V::mini(V::to_int(vd), V::seti(d.height - 1));
      const F measured =
          V::gather(d.data, V::addi(V::muli(row, V::seti(static_cast<int>(d.stride))), V::muli(column, V::seti(4))));
      const F difference = V::sub(measured, qi);
      const F limit = V::max(V::mul(V::set(d.occlusion_relative), qi), V::set(d.occlusion_absolute));
      const M measures = V::both(inside, V::less(zero, measured));
      occluded = V::both(measures, V::less(limit, difference));
      if (d.occluders) {
        const F to_occluders = V::set(d.occluders_scale);
        const auto uh = V::mini(V::to_int(V::mul(left, to_occluders)), V::seti(d.occluders_width - 1));
        const auto vh = V::mini(V::to_int(V::mul(top, to_occluders)), V::seti(d.occluders_height - 1));
        const int stride = static_cast<int>(d.occluders_stride);
        occluded = V::either(occluded,
                             V::both(inside, V::nonzero_byte(d.occluders, V::addi(V::muli(vh, V::seti(stride)), uh),
                                                             stride * (d.occluders_height - 1) + d.occluders_width)));
      }
      tally.occluded += V::count(occluded);
      seen = V::without(seen, occluded);
      has_depth = V::both(measures, seen);
      r_depth = V::keep(has_depth, difference);
    }
    tally.seen += V::count(seen);

    auto patch = [&] {
      if constexpr (kQuads)
        return Quad<V>(in.level, u, v);
      else
        return Patch<V>(in.level, u, v, kGradient != GradientSource::Reference && kWanted != Wanted::Moments);
    }();
    const F intensity = V::load(p.intensity + i);
    if constexpr (kWanted == Wanted::Moments) {
      const F middle = V::set(128);
      const F before = V::keep(seen, V::sub(intensity, middle)), now = V::keep(seen, V::sub(patch.value, middle));
      tally.x = V::add(tally.x, before), tally.y = V::add(tally.y, now);
      tally.xx = V::fma(before, before, tally.xx), tally.yy = V::fma(now, now, tally.yy);
      tally.xy = V::fma(before, now, tally.xy);
      continue;
    }
    if constexpr (kGradient != GradientSource::Image) {
      // A small piece of surface appears 1 / Z~ times as large as in the reference, so its gradient is Z~ times as
      // large. Its rotation about the optical axis and its shear are neglected.
      const F scale = V::mul(V::keep(seen, Z), V::set(kGradient == GradientSource::Mean ? view.gain : 2 * view.gain));
      const F gx = V::mul(scale, V::load(p.gu + i)), gy = V::mul(scale, V::load(p.gv + i));
      if constexpr (kGradient == GradientSource::Mean)
        patch.gx = V::fma(half, patch.gx, gx), patch.gy = V::fma(half, patch.gy, gy);
      else
        patch.gx = gx, patch.gy = gy;
    }
    const F r = V::sub(V::fma(minus_gain, intensity, patch.value), offset);
    const F gu = V::mul(patch.gx, fx_half), gv = V::mul(patch.gy, fy_half);
    const F along = V::fma(gu, xn, V::mul(gv, yn));
    // dX~/dq = t, and dr/dX~ = (gu, gv, -along) / Z.
    const F dr_dq = V::mul(V::fma(gu, t0, V::sub(V::mul(gv, t1), V::mul(along, t2))), iz);
    const F by_depth = V::mul(dr_dq, V::load(p.sigma_q + i));
    const F gradient = V::fma(patch.gx, patch.gx, V::mul(patch.gy, patch.gy));
    const F extra = V::fma(by_depth, by_depth, V::mul(gradient2, gradient));

    if constexpr (kWanted == Wanted::Costs) {
      tally.kept = V::add(tally.kept, V::keep(seen, tukey_kept<V>(r, V::add(extra, s2_intensity), in.noise.tukey)));
      if constexpr (kDepth) {
        const F kept = tukey_kept<V>(r_depth, V::set(in.depth->sigma * in.depth->sigma), in.noise.tukey);
        tally.depth_kept = V::add(tally.depth_kept, V::keep(has_depth, kept));
        tally.with_depth += V::count(has_depth);
      }
    } else if constexpr (kWanted == Wanted::Columns) {
      const int k = at + i;
      const F bx = V::fma(c0, qi, xn), by = V::fma(c1, qi, yn), bz = V::fma(c2, qi, one);
      const F inverse_s = V::inverse_sqrt(V::add(extra, s2_intensity));
      const F e = V::abs(V::mul(r, inverse_s));
      const F weight = V::div(V::mul(V::mul(inverse_s, inverse_s), huber), V::max(e, huber));
      const F bounded = V::min(e, huber);
      tally.cost = V::add(tally.cost, V::keep(seen, V::mul(bounded, V::fma(V::set(-0.5f), bounded, e))));
      float(*c)[kBlock] = block->photo;
      V::store(block->weight + k, V::keep(seen, weight));
      V::store(c[0] + k, V::mul(gu, qi));
      V::store(c[1] + k, V::mul(gv, qi));
      V::store(c[2] + k, V::sub(zero, V::mul(along, qi)));
      V::store(c[3] + k, V::sub(zero, V::fma(along, by, V::mul(bz, gv))));
      V::store(c[4] + k, V::fma(along, bx, V::mul(bz, gu)));
      V::store(c[5] + k, V::sub(V::mul(gv, bx), V::mul(gu, by)));
      V::store(c[kReference] + k, V::sub(zero, intensity));
      V::store(c[kResidual] + k, r);
      if constexpr (kDepth) {
        const Depth& d = *in.depth;
        const F pu = V::load(p.u + i), pv = V::load(p.v + i);
        tally.u_min = V::min(tally.u_min, pu), tally.u_max = V::max(tally.u_max, pu);
        tally.v_min = V::min(tally.v_min, pv), tally.v_max = V::max(tally.v_max, pv);
        V::store(c[kByDepth] + k, dr_dq);
        V::store(c[kByDepth + 1] + k, V::mul(dr_dq, V::sub(pu, V::set(in.points.u[0]))));
        V::store(c[kByDepth + 2] + k, V::mul(dr_dq, V::sub(pv, V::set(in.points.v[0]))));
        // r_depth = measured - q / Z~; the predicted q' = q / Z~ moves by -q' dZ~ / Z~.
        const float inverse_sigma = d.weight > 0 ? 1 / d.sigma : 0;
        const F eq = V::abs(V::mul(r_depth, V::set(inverse_sigma))), bounded_q = V::min(eq, huber);
        const F wq = V::div(V::set(d.weight * inverse_sigma * inverse_sigma * in.noise.huber), V::max(eq, huber));
        const F cost = V::mul(V::set(d.weight), V::mul(bounded_q, V::fma(V::set(-0.5f), bounded_q, eq)));
        tally.cost = V::add(tally.cost, V::keep(has_depth, cost));
        V::store(block->depth_weight + k, V::keep(has_depth, wq));
        V::store(block->depth[0] + k, V::mul(qi, qi));
        V::store(block->depth[1] + k, V::mul(qi, by));
        V::store(block->depth[2] + k, V::sub(zero, V::mul(qi, bx)));
        V::store(block->depth[3] + k, r_depth);
      }
    } else {
      V::store(out->r + i, V::keep(seen, r));
      V::store(out->extra + i, V::keep(seen, extra));
      V::store(out->value + i, V::keep(seen, patch.value));
      V::store(out->r_depth + i, r_depth);
      V::store_bits(out->visibility + i, seen, has_depth, occluded);
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
