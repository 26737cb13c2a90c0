// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/kernel/impl/edge_rows.hpp"
#include "dot/kernel/impl/image_rows.hpp"
#include "dot/kernel/impl/image_samples.hpp"
#include "dot/kernel/impl/photometric_costs.hpp"
#include "dot/kernel/impl/photometric_sums.hpp"
#include "dot/kernel/impl/plane_fitter.hpp"
#include "dot/kernel/impl/strongest_gradients.hpp"
#include "dot/kernel/kernels.hpp"

/// @file
/// The kernels over vectors of V::W lanes. A unit uses `kernels_of<V>` with its own V. All are templates over V, and
/// the name V is local to its unit, so no two units share a function. V is a type of kernel/lanes.hpp or of
/// src/kernels/. It has, besides W, the types F (float lanes), I (32-bit integers), M (a mask), and static functions:
///
///     F set(float), load(const float*); void store(float*, F); float sum(F);
///     F load_words(const unsigned short*);                       // W of them
///     void load_pairs(const float*, F& even, F& odd);            // of 2 W values
///     F add, sub, mul, div, min, max(F, F); fma(F a, F b, F c);  // a b + c; max(NaN, b) = b
///     F abs(F), inverse_sqrt(F);                                 // the latter to about float precision
///     M less(F, F), not_less(F, F);                              // false for NaN
///     M both(M, M), either(M, M), without(M a, M b); F keep(M, F); int count(M);  // a and not b; f or zero
///     M zero_bytes(const unsigned char*);                        // of W bytes
///     void store_bits(unsigned char*, M bit0, M bit1, M bit2);   // W bytes
///     I seti(int), to_int(F), addi, muli, mini(I, I); F to_float(I);  // to_int truncates
///     F byte<k>(I); F gather(const float*, I bytes);             // byte k as a number; at a byte offset
///     I gather4(const unsigned char*, I); M nonzero_byte(const unsigned char*, I, int bytes);

namespace dot::kernel {

/// The set of kernels over V.
template <typename V>
constexpr Kernels kernels_of(const char* name) {
  return {name,
          residuals<V>,
          costs<V>,
          moments<V>,
          linearize<V>,
          sample<V>,
          fit_planes<V>,
          strongest_gradients<V>,
          invert_depth<V, unsigned short>,
          invert_depth<V, float>,
          take_bias<V>,
          halve_depth<V>,
          blur<V>,
          halve<V>,
          compare_edges<V>,
          sum_edges<V>};
}

}  // namespace dot::kernel
