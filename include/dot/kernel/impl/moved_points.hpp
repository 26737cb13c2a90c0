// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/photometric.hpp"

/// @file
/// Where points are in the new image, and the depth that was measured there, over V::W lanes, see impl/kernels_of.hpp.

namespace dot::kernel {

/// What is the same for all points: the view, the bounds of the image and the noise, each number in all lanes.
template <typename V>
struct Constants {
  using F = typename V::F;
  F R0, R1, R2, R3, R4, R5, R6, R7, R8;  ///< R by rows
  F t0, t1, t2;
  F c0, c1, c2;  ///< minus the centre
  F fx, fy, cx, cy;
  F fx_half, fy_half;
  F u_end, v_end;  ///< least coordinates that cannot be sampled any more
  F minus_gain, offset;
  F s2_intensity;
  F gradient2;  ///< of gradients times two
  F huber;

  explicit Constants(const Input& in)
      : R0(V::set(in.view.R[0])),
        R1(V::set(in.view.R[1])),
        R2(V::set(in.view.R[2])),
        R3(V::set(in.view.R[3])),
        R4(V::set(in.view.R[4])),
        R5(V::set(in.view.R[5])),
        R6(V::set(in.view.R[6])),
        R7(V::set(in.view.R[7])),
        R8(V::set(in.view.R[8])),
        t0(V::set(in.view.t[0])),
        t1(V::set(in.view.t[1])),
        t2(V::set(in.view.t[2])),
        c0(V::set(-in.view.centre[0])),
        c1(V::set(-in.view.centre[1])),
        c2(V::set(-in.view.centre[2])),
        fx(V::set(in.view.fx)),
        fy(V::set(in.view.fy)),
        cx(V::set(in.view.cx)),
        cy(V::set(in.view.cy)),
        fx_half(V::set(0.5f * in.view.fx)),
        fy_half(V::set(0.5f * in.view.fy)),
        u_end(V::set(static_cast<float>(in.level.width - 3))),
        v_end(V::set(static_cast<float>(in.level.height - 3))),
        minus_gain(V::set(-in.view.gain)),
        offset(V::set(in.view.offset)),
        s2_intensity(V::set(in.noise.s2)),
        gradient2(V::set(0.25f * in.noise.gradient2)),
        huber(V::set(in.noise.huber)) {}
};

/// Points as seen from the new camera: X~ = q X = Z (xn, yn, 1).
template <typename V>
struct MovedPoints {
  using F = typename V::F;
  F Z, iz;   ///< Z and 1 / Z
  F xn, yn;  ///< normalised coordinates
  F u, v;    ///< pixels; inside the image in all lanes
  F q;       ///< inverse depth, q / Z
  typename V::M
      seen;  ///< lanes whose point is inside the image, and not excluded; the other lanes of iz, xn, yn, q are 0

  /// Moves the points from index i on.
  MovedPoints(const Constants<V>& c, const Points& p, int i) {
    const F x = V::load(p.x + i), y = V::load(p.y + i), q_before = V::load(p.q + i);
    const F one = V::set(1), z_min = V::set(1e-3f);
    const F X = V::fma(c.R0, x, V::fma(c.R1, y, V::fma(c.t0, q_before, c.R2)));
    const F Y = V::fma(c.R3, x, V::fma(c.R4, y, V::fma(c.t1, q_before, c.R5)));
    Z = V::fma(c.R6, x, V::fma(c.R7, y, V::fma(c.t2, q_before, c.R8)));
    iz = V::div(one, Z), xn = V::mul(X, iz), yn = V::mul(Y, iz);
    u = V::fma(c.fx, xn, c.cx), v = V::fma(c.fy, yn, c.cy);
    seen = V::both(V::not_less(Z, z_min), V::both(V::both(V::not_less(u, one), V::less(u, c.u_end)),
                                                  V::both(V::not_less(v, one), V::less(v, c.v_end))));
    if (p.excluded) seen = V::both(seen, V::zero_bytes(p.excluded + i));
    // Values of the other lanes, which may be infinite or NaN, must not reach an address or a sum.
    u = V::min(V::max(u, one), c.u_end), v = V::min(V::max(v, one), c.v_end);
    xn = V::keep(seen, xn), yn = V::keep(seen, yn), iz = V::keep(seen, iz);
    q = V::keep(seen, V::mul(q_before, iz));
  }
};

/// The measured depth where points are seen.
template <typename V>
struct MeasuredDepth {
  using F = typename V::F;
  using M = typename V::M;
  M exists = V::less(V::set(1), V::set(0));  ///< lanes that are seen and have one
  M occluded = exists;                       ///< lanes whose point is behind something nearer
  F r = V::set(0);                           ///< measured minus predicted inverse depth, 0 where none exists

  /// Without measurements.
  MeasuredDepth() = default;

  /// Takes what is occluded out of `points.seen`.
  MeasuredDepth(const Depth& d, MovedPoints<V>& points) {
    const F half = V::set(0.5f), left = V::add(points.u, half), top = V::add(points.v, half), scale = V::set(d.scale);
    const F ud = V::mul(left, scale), vd = V::mul(top, scale);
    const M inside = V::both(points.seen, V::both(V::less(ud, V::set(static_cast<float>(d.width))),
                                                  V::less(vd, V::set(static_cast<float>(d.height)))));
    const auto column = V::mini(V::to_int(ud), V::seti(d.width - 1));
    const auto row = V::mini(V::to_int(vd), V::seti(d.height - 1));
    const F measured =
        V::gather(d.data, V::addi(V::muli(row, V::seti(static_cast<int>(d.stride))), V::muli(column, V::seti(4))));
    const F difference = V::sub(measured, points.q);
    const F limit = V::max(V::mul(V::set(d.occlusion_relative), points.q), V::set(d.occlusion_absolute));
    const M measures = V::both(inside, V::less(V::set(0), measured));
    occluded = V::both(measures, V::less(limit, difference));
    if (d.occluders) occluded = V::either(occluded, V::both(inside, is_covered(d, left, top)));
    points.seen = V::without(points.seen, occluded);
    exists = V::both(measures, points.seen);
    r = V::keep(exists, difference);
  }

 private:
  /// Whether a nearer object covers the pixel at these distances from the image's edges.
  static M is_covered(const Depth& d, F left, F top) {
    const F scale = V::set(d.occluders_scale);
    const auto u = V::mini(V::to_int(V::mul(left, scale)), V::seti(d.occluders_width - 1));
    const auto v = V::mini(V::to_int(V::mul(top, scale)), V::seti(d.occluders_height - 1));
    const int stride = static_cast<int>(d.occluders_stride);
    return V::nonzero_byte(d.occluders, V::addi(V::muli(v, V::seti(stride)), u),
                           stride * (d.occluders_height - 1) + d.occluders_width);
  }
};

}  // namespace dot::kernel
