// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/photometric_factor.hpp"

/// @file
/// Residuals and Jacobians of a block of points as columns, see impl/kernels_of.hpp. impl/photometric_sums.hpp sums
/// their products.

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

/// Lever arms of the twist: the points minus the centre, over Z.
template <typename V>
struct Arms {
  typename V::F x, y, z;

  Arms(const Constants<V>& c, const MovedPoints<V>& points)
      : x(V::fma(c.c0, points.q, points.xn)),
        y(V::fma(c.c1, points.q, points.yn)),
        z(V::fma(c.c2, points.q, V::set(1))) {}
};

/// Huber's cost of residuals in sigmas. @param e not negative.
template <typename V>
typename V::F huber_cost(typename V::F e, typename V::F huber) {
  const typename V::F bounded = V::min(e, huber);
  return V::mul(bounded, V::fma(V::set(-0.5f), bounded, e));
}

/// Writes the columns of the photometric residuals to the block from index k on, and adds their cost.
template <typename V>
void store_columns(const Constants<V>& c, const MovedPoints<V>& points, const Arms<V>& arm, const Factor<V>& f,
                   Block& block, int k, Tally<V>& tally) {
  using F = typename V::F;
  const F zero = V::set(0);
  const F inverse_s = V::inverse_sqrt(V::add(f.extra, c.s2_intensity));
  const F e = V::abs(V::mul(f.r, inverse_s));
  const F weight = V::div(V::mul(V::mul(inverse_s, inverse_s), c.huber), V::max(e, c.huber));
  tally.cost = V::add(tally.cost, V::keep(points.seen, huber_cost<V>(e, c.huber)));
  float(*column)[kBlock] = block.photo;
  V::store(block.weight + k, V::keep(points.seen, weight));
  V::store(column[0] + k, V::mul(f.gu, points.q));
  V::store(column[1] + k, V::mul(f.gv, points.q));
  V::store(column[2] + k, V::sub(zero, V::mul(f.along, points.q)));
  V::store(column[3] + k, V::sub(zero, V::fma(f.along, arm.y, V::mul(arm.z, f.gv))));
  V::store(column[4] + k, V::fma(f.along, arm.x, V::mul(arm.z, f.gu)));
  V::store(column[5] + k, V::sub(V::mul(f.gv, arm.x), V::mul(f.gu, arm.y)));
  V::store(column[kReference] + k, V::sub(zero, f.intensity));
  V::store(column[kResidual] + k, f.r);
}

/// Writes the columns of the depth error's modes, and extends the bounds of (u, v). @param p the points from index i
/// on.
template <typename V>
void store_modes(const Input& in, const Points& p, int i, const Factor<V>& f, Block& block, int k, Tally<V>& tally) {
  using F = typename V::F;
  const F u = V::load(p.u + i), v = V::load(p.v + i);
  tally.u_min = V::min(tally.u_min, u), tally.u_max = V::max(tally.u_max, u);
  tally.v_min = V::min(tally.v_min, v), tally.v_max = V::max(tally.v_max, v);
  V::store(block.photo[kByDepth] + k, f.dr_dq);
  V::store(block.photo[kByDepth + 1] + k, V::mul(f.dr_dq, V::sub(u, V::set(in.points.u[0]))));
  V::store(block.photo[kByDepth + 2] + k, V::mul(f.dr_dq, V::sub(v, V::set(in.points.v[0]))));
}

/// Writes the columns of the depth residuals, and adds their cost.
/// r_depth = measured - q / Z~; the predicted q' = q / Z~ moves by -q' dZ~ / Z~.
template <typename V>
void store_depth_columns(const Input& in, const Constants<V>& c, const MovedPoints<V>& points, const Arms<V>& arm,
                         const MeasuredDepth<V>& depth, Block& block, int k, Tally<V>& tally) {
  using F = typename V::F;
  const Depth& d = *in.depth;
  const float inverse_sigma = d.weight > 0 ? 1 / d.sigma : 0;
  const F e = V::abs(V::mul(depth.r, V::set(inverse_sigma)));
  const F weight = V::div(V::set(d.weight * inverse_sigma * inverse_sigma * in.noise.huber), V::max(e, c.huber));
  const F cost = V::mul(V::set(d.weight), huber_cost<V>(e, c.huber));
  tally.cost = V::add(tally.cost, V::keep(depth.exists, cost));
  V::store(block.depth_weight + k, V::keep(depth.exists, weight));
  V::store(block.depth[0] + k, V::mul(points.q, points.q));
  V::store(block.depth[1] + k, V::mul(points.q, arm.y));
  V::store(block.depth[2] + k, V::sub(V::set(0), V::mul(points.q, arm.x)));
  V::store(block.depth[3] + k, depth.r);
}

}  // namespace dot::kernel
