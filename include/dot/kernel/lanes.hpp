// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "dot/abi.hpp"

/// @file
/// SIMD lanes in plain C++, for code that is generic over lanes (kernel/impl/kernels_of.hpp). There are single lanes,
/// and four lanes by the vector types that GCC and Clang map to the target machine (SSE2, NEON). They are in the
/// namespace of the including build and are compiled with its flags.

DOT_BEGIN_NAMESPACE

struct ScalarLanes {
  static constexpr int W = 1;
  using F = float;
  using I = std::int32_t;
  using M = bool;

  static F set(float a) { return a; }
  static F load(const float* p) { return *p; }
  static F load_words(const std::uint16_t* p) { return static_cast<F>(*p); }
  static void load_pairs(const float* p, F& even, F& odd) { even = p[0], odd = p[1]; }
  static void store(float* p, F a) { *p = a; }
  static F sum(F a) { return a; }
  static F add(F a, F b) { return a + b; }
  static F sub(F a, F b) { return a - b; }
  static F mul(F a, F b) { return a * b; }
  static F div(F a, F b) { return a / b; }
  static F fma(F a, F b, F c) { return a * b + c; }
  static F min(F a, F b) { return a < b ? a : b; }
  static F max(F a, F b) { return a > b ? a : b; }
  static F abs(F a) { return std::abs(a); }
  static F inverse_sqrt(F a) { return 1 / std::sqrt(a); }
  static M less(F a, F b) { return a < b; }
  static M not_less(F a, F b) { return a >= b; }
  static M both(M a, M b) { return a && b; }
  static M either(M a, M b) { return a || b; }
  static M without(M a, M b) { return a && !b; }
  static F keep(M m, F a) { return m ? a : 0; }
  static int count(M m) { return m; }
  static M zero_bytes(const unsigned char* p) { return *p == 0; }
  static void store_bits(unsigned char* p, M a, M b, M c) { *p = static_cast<unsigned char>(a + 2 * b + 4 * c); }
  static I seti(int a) { return a; }
  static I to_int(F a) { return static_cast<I>(a); }
  static F to_float(I a) { return static_cast<F>(a); }
  static I addi(I a, I b) { return a + b; }
  static I muli(I a, I b) { return a * b; }
  static I mini(I a, I b) { return a < b ? a : b; }
  template <int k>
  static F byte(I a) {
    return static_cast<F>((static_cast<std::uint32_t>(a) >> (8 * k)) & 255u);
  }
  static F gather(const float* base, I bytes) {
    float a;
    std::memcpy(&a, reinterpret_cast<const unsigned char*>(base) + bytes, sizeof a);
    return a;
  }
  static I gather4(const unsigned char* base, I at) {
    const unsigned char* p = base + at;
    return static_cast<I>(p[0] | static_cast<std::uint32_t>(p[1]) << 8 | static_cast<std::uint32_t>(p[2]) << 16 |
                          static_cast<std::uint32_t>(p[3]) << 24);
  }
  static M nonzero_byte(const unsigned char* base, I at, int) { return base[at] != 0; }
};

#if defined(__GNUC__)

/// A mask is an integer vector of 0 and -1, the result of comparisons.
struct VectorLanes {
  static constexpr int W = 4;
  typedef float F __attribute__((vector_size(16)));
  typedef std::int32_t I __attribute__((vector_size(16)));
  using M = I;

  static F set(float a) { return F{a, a, a, a}; }
  static F load(const float* p) {
    F a;
    std::memcpy(&a, p, sizeof a);
    return a;
  }
  static F load_words(const std::uint16_t* p) { return to_float(I{p[0], p[1], p[2], p[3]}); }
  static void load_pairs(const float* p, F& even, F& odd) {
    const F a = load(p), b = load(p + 4);
    even = F{a[0], a[2], b[0], b[2]}, odd = F{a[1], a[3], b[1], b[3]};
  }
  static void store(float* p, F a) { std::memcpy(p, &a, sizeof a); }
  static float sum(F a) { return (a[0] + a[2]) + (a[1] + a[3]); }
  static F add(F a, F b) { return a + b; }
  static F sub(F a, F b) { return a - b; }
  static F mul(F a, F b) { return a * b; }
  static F div(F a, F b) { return a / b; }
  static F fma(F a, F b, F c) { return a * b + c; }
  static F min(F a, F b) { return select(a < b, a, b); }
  static F max(F a, F b) { return select(a > b, a, b); }
  static F abs(F a) { return keep(seti(0x7fffffff), a); }
  static F inverse_sqrt(F a) { return set(1) / F{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])}; }
  static M less(F a, F b) { return a < b; }
  static M not_less(F a, F b) { return a >= b; }
  static M both(M a, M b) { return a & b; }
  static M either(M a, M b) { return a | b; }
  static M without(M a, M b) { return a & ~b; }
  static F keep(M m, F a) { return reinterpret_cast<F>(reinterpret_cast<I>(a) & m); }
  static int count(M m) { return -((m[0] + m[1]) + (m[2] + m[3])); }
  static M zero_bytes(const unsigned char* p) { return I{p[0], p[1], p[2], p[3]} == seti(0); }
  static void store_bits(unsigned char* p, M a, M b, M c) {
    const I bits = (a & 1) | (b & 2) | (c & 4);
    for (int k = 0; k < W; ++k) p[k] = static_cast<unsigned char>(bits[k]);
  }
  static I seti(int a) { return I{a, a, a, a}; }
  static I to_int(F a) { return __builtin_convertvector(a, I); }
  static F to_float(I a) { return __builtin_convertvector(a, F); }
  static I addi(I a, I b) { return a + b; }
  static I muli(I a, I b) { return a * b; }
  static I mini(I a, I b) {
    const I m = a < b;
    return (a & m) | (b & ~m);
  }
  template <int k>
  static F byte(I a) {
    return to_float((a >> (8 * k)) & 255);
  }
  static F gather(const float* base, I bytes) {
    return F{ScalarLanes::gather(base, bytes[0]), ScalarLanes::gather(base, bytes[1]),
             ScalarLanes::gather(base, bytes[2]), ScalarLanes::gather(base, bytes[3])};
  }
  static I gather4(const unsigned char* base, I at) {
    return I{ScalarLanes::gather4(base, at[0]), ScalarLanes::gather4(base, at[1]), ScalarLanes::gather4(base, at[2]),
             ScalarLanes::gather4(base, at[3])};
  }
  static M nonzero_byte(const unsigned char* base, I at, int) {
    return I{base[at[0]], base[at[1]], base[at[2]], base[at[3]]} != seti(0);
  }

 private:
  static F select(M m, F a, F b) {
    return reinterpret_cast<F>((reinterpret_cast<I>(a) & m) | (reinterpret_cast<I>(b) & ~m));
  }
};
using PortableLanes = VectorLanes;

#else
using PortableLanes = ScalarLanes;
#endif

DOT_END_NAMESPACE
