// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/align/kernel.hpp"

/// @file
/// The kernels of align/kernel.hpp over a vector of V::W lanes: src/kernels/ and impl/portable_kernels.hpp each give a
/// V and take `kernels_of<V>`. All here are templates over V, and V is a name of its unit's own, so no two units share
/// a function. A V has, besides W, the types F (float lanes), I (32-bit integers), M (a mask), and static functions:
///
///     F set(float), load(const float*); void store(float*, F); float sum(F);
///     F add, sub, mul, div, min, max(F, F); fma(F a, F b, F c);  // a b + c; max(NaN, b) = b
///     F abs(F), inverse_sqrt(F);                                 // the latter to about float precision
///     M less(F, F), not_less(F, F);                              // false for NaN
///     M both(M, M), either(M, M), without(M a, M b); F keep(M, F); int count(M);  // a and not b; f or zero
///     M zero_bytes(const unsigned char*);                        // of W bytes
///     void store_bits(unsigned char*, M bit0, M bit1, M bit2);   // W bytes
///     I seti(int), to_int(F), addi, muli, mini(I, I); F to_float(I);  // to_int truncates
///     F byte<k>(I); F gather(const float*, I bytes);             // byte k as a number; at a byte offset
///     I gather4(const unsigned char*, I); M nonzero_byte(const unsigned char*, I, int bytes);
///
/// The work goes by blocks of points that stay in the first cache: first residuals and Jacobians are written as
/// columns, then products of columns are summed with the sums in registers. Lanes that see nothing have weight zero.
/// Float sums end with a chunk of blocks and are added up in double, in the order of the points.

namespace dot::kernel {

constexpr int kBlock = 128;         // points
constexpr int kBlocksInAChunk = 8;  // blocks whose sums are float
constexpr int kReference = 6;       // columns: the pose's six, then minus the reference's intensity (of the gain), ...
constexpr int kMinusOne = 7;        // ... of the offset, ...
constexpr int kResidual = 8;        // ... the residual, ...
constexpr int kByDepth = 9;         // ... and its derivative by inverse depth, times 1, u and v
constexpr int kColumns = 12;

/// The columns of one block.
struct Block {
  alignas(64) float photo[kColumns][kBlock];
  alignas(64) float weight[kBlock];
  alignas(64) float depth[5][kBlock];  ///< of the depth residual: derivatives by z, alpha, beta, the residual, one
  alignas(64) float depth_weight[kBlock];
};

/// What is summed while residuals are computed.
template <typename V>
struct Tally {
  typename V::F cost = V::set(0);
  typename V::F u_min = V::set(1e30f), u_max = V::set(-1e30f), v_min = V::set(1e30f), v_max = V::set(-1e30f);
  int seen = 0, occluded = 0;
};

/// Bilinear value and, where wanted, central differences (times two) of the 4x4 pixels about (u, v).
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
    // The four neighbours of a row come with one load.
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

/// Residuals of the first `n` points of `p`, a multiple of the lanes: into `out`, or as columns of `block` from `at`
/// on.
template <typename V, GradientSource kGradient, bool kColumnsWanted, bool kDepth>
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
    // Whatever the other lanes hold, infinities and NaN too, must not reach an address nor a sum.
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
      if (d.hidden) {
        const F to_hidden = V::set(d.hidden_scale);
        const auto uh = V::mini(V::to_int(V::mul(left, to_hidden)), V::seti(d.hidden_width - 1));
        const auto vh = V::mini(V::to_int(V::mul(top, to_hidden)), V::seti(d.hidden_height - 1));
        const int stride = static_cast<int>(d.hidden_stride);
        occluded =
            V::either(occluded, V::both(inside, V::nonzero_byte(d.hidden, V::addi(V::muli(vh, V::seti(stride)), uh),
                                                                stride * (d.hidden_height - 1) + d.hidden_width)));
      }
      tally.occluded += V::count(occluded);
      seen = V::without(seen, occluded);
      has_depth = V::both(measures, seen);
      r_depth = V::keep(has_depth, difference);
    }
    tally.seen += V::count(seen);

    Patch<V> patch(in.level, u, v, kGradient != GradientSource::Reference);
    if constexpr (kGradient != GradientSource::Image) {
      // A small piece of surface appears 1 / Z~ times as large as in the reference, so its gradient is Z~ times that
      // one; its turn about the optical axis and its shear are left out.
      const F scale = V::mul(V::keep(seen, Z), V::set(kGradient == GradientSource::Mean ? view.gain : 2 * view.gain));
      const F gx = V::mul(scale, V::load(p.gu + i)), gy = V::mul(scale, V::load(p.gv + i));
      if constexpr (kGradient == GradientSource::Mean)
        patch.gx = V::fma(half, patch.gx, gx), patch.gy = V::fma(half, patch.gy, gy);
      else
        patch.gx = gx, patch.gy = gy;
    }
    const F intensity = V::load(p.intensity + i);
    const F r = V::sub(V::fma(minus_gain, intensity, patch.value), offset);
    const F gu = V::mul(patch.gx, fx_half), gv = V::mul(patch.gy, fy_half);
    const F along = V::fma(gu, xn, V::mul(gv, yn));
    // dX~/dq = t, and dr/dX~ = (gu, gv, -along) / Z.
    const F dr_dq = V::mul(V::fma(gu, t0, V::sub(V::mul(gv, t1), V::mul(along, t2))), iz);
    const F by_depth = V::mul(dr_dq, V::load(p.sigma_q + i));
    const F gradient = V::fma(patch.gx, patch.gx, V::mul(patch.gy, patch.gy));
    const F extra = V::fma(by_depth, by_depth, V::mul(gradient2, gradient));

    if constexpr (kColumnsWanted) {
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

/// The last points of a set, fewer than the lanes, filled up with copies of the last one that are excluded.
template <typename V>
struct Tail {
  float f[9][V::W];
  unsigned char excluded[V::W];

  /// Points from..from + count of `p`; the result borrows this.
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

template <typename V, GradientSource kGradient, bool kDepth>
void all_residuals(const Input& in, const Residuals& out) {
  Tally<V> tally;
  const int n = in.points.n, whole = n / V::W * V::W;
  evaluate<V, kGradient, false, kDepth>(in, in.points, whole, &out, nullptr, 0, tally);
  if (whole == n) return;
  Tail<V> tail;
  float f[4][V::W];
  unsigned char bits[V::W];
  const Residuals staged{f[0], f[1], f[2], f[3], bits};
  evaluate<V, kGradient, false, kDepth>(in, tail.fill(in.points, whole, n - whole), V::W, &staged, nullptr, 0, tally);
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

  template <int kParameters, bool kDepth>
  void add(const Block& b, int n) {
    // Tiles of about a dozen sums: as many as there are registers for, and enough to hide the latency of each.
    add_products<V, 0, 2, 0, 6>(b.weight, b.photo, n, photo);
    add_products<V, 2, 4, 2, 4>(b.weight, b.photo, n, photo);
    if constexpr (kParameters == 6) {
      add_products<V, 0, 6, kResidual, 1>(b.weight, b.photo, n, photo);
    } else {
      add_products<V, 0, 4, kReference, 3>(b.weight, b.photo, n, photo);
      add_products<V, 4, 4, kReference, 3>(b.weight, b.photo, n, photo);
    }
    if constexpr (kDepth) {
      add_products<V, 0, 4, kByDepth, 3>(b.weight, b.photo, n, photo);
      add_products<V, 4, 4, kByDepth, 3>(b.weight, b.photo, n, photo);
      add_products<V, 0, 3, 0, 5>(b.depth_weight, b.depth, n, depth);
    }
  }

  /// Adds to `out`, whose H gets its upper triangle.
  template <int kParameters, bool kDepth>
  void flush(Sums& out) {
    for (int r = 0; r < kParameters; ++r) {
      for (int c = r; c < kParameters; ++c) out.H[8 * r + c] += static_cast<double>(V::sum(photo[r][c]));
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

/// The modes that grow over the region, from sums over u and v: about its middle, over its half extents.
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

template <typename V, GradientSource kGradient, int kParameters, bool kDepth>
void all_products(const Input& in, Sums& out) {
  Block block;
  for (float& f : block.photo[kMinusOne]) f = -1;
  for (float& f : block.depth[4]) f = 1;
  Tally<V> tally;
  Partial<V> partial;
  const int n = in.points.n;
  for (int start = 0, blocks = 0; start < n; start += kBlock) {
    const int count = n - start < kBlock ? n - start : kBlock, whole = count / V::W * V::W;
    evaluate<V, kGradient, true, kDepth>(in, advanced<V>(in.points, start), whole, nullptr, &block, 0, tally);
    if (whole < count) {
      Tail<V> tail;
      const Points last = tail.fill(in.points, start + whole, count - whole);
      evaluate<V, kGradient, true, kDepth>(in, last, V::W, nullptr, &block, whole, tally);
    }
    partial.template add<kParameters, kDepth>(block, (count + V::W - 1) / V::W * V::W);
    if (++blocks == kBlocksInAChunk || start + kBlock >= n) {
      partial.template flush<kParameters, kDepth>(out);
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

template <typename V, GradientSource kGradient, int kParameters>
void linearize_by(const Input& in, Sums& out) {
  in.depth ? all_products<V, kGradient, kParameters, true>(in, out)
           : all_products<V, kGradient, kParameters, false>(in, out);
}

template <typename V, int kParameters>
void linearize(const Input& in, Sums& out) {
  out = Sums{};
  if (in.points.n <= 0 || in.level.width < 5 || in.level.height < 5) return;  // sampling needs a border
  switch (in.gradient) {
    case GradientSource::Image: return linearize_by<V, GradientSource::Image, kParameters>(in, out);
    case GradientSource::Reference: return linearize_by<V, GradientSource::Reference, kParameters>(in, out);
    case GradientSource::Mean: return linearize_by<V, GradientSource::Mean, kParameters>(in, out);
  }
}

/// The three functions over V.
template <typename V>
constexpr Kernels kernels_of(const char* name) {
  return {name, residuals<V>, linearize<V, 8>, linearize<V, 6>};
}

}  // namespace dot::kernel
