// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// Built with -mavx512f -mavx512bw -mavx512dq -mfma. See avx2.cpp about included headers.
#include <immintrin.h>

#include "dot/kernel/impl/kernels_of.hpp"
#include "variants.hpp"

namespace dot::kernel {
namespace {

struct Avx512 {
  static constexpr int W = 16;
  using F = __m512;
  using I = __m512i;
  using M = __mmask16;

  static F set(float a) { return _mm512_set1_ps(a); }
  static F load(const float* p) { return _mm512_loadu_ps(p); }
  static F load_words(const unsigned short* p) {
    return _mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))));
  }
  static void load_pairs(const float* p, F& even, F& odd) {
    const I at = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    const F a = load(p), b = load(p + W);
    even = _mm512_permutex2var_ps(a, at, b), odd = _mm512_permutex2var_ps(a, addi(at, seti(1)), b);
  }
  static void store(float* p, F a) { _mm512_storeu_ps(p, a); }
  static float sum(F a) { return _mm512_reduce_add_ps(a); }
  static F add(F a, F b) { return _mm512_add_ps(a, b); }
  static F sub(F a, F b) { return _mm512_sub_ps(a, b); }
  static F mul(F a, F b) { return _mm512_mul_ps(a, b); }
  static F div(F a, F b) { return _mm512_div_ps(a, b); }
  static F fma(F a, F b, F c) { return _mm512_fmadd_ps(a, b, c); }
  static F min(F a, F b) { return _mm512_min_ps(a, b); }
  static F max(F a, F b) { return _mm512_max_ps(a, b); }
  static F abs(F a) { return _mm512_abs_ps(a); }
  static F inverse_sqrt(F a) {
    // One Newton step from 14 to 23 bits.
    const F y = _mm512_rsqrt14_ps(a), ay = mul(a, y);
    return mul(y, _mm512_fnmadd_ps(mul(ay, y), set(0.5f), set(1.5f)));
  }
  static M less(F a, F b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  static M not_less(F a, F b) { return _mm512_cmp_ps_mask(a, b, _CMP_GE_OQ); }
  static M both(M a, M b) { return _kand_mask16(a, b); }
  static M either(M a, M b) { return _kor_mask16(a, b); }
  static M without(M a, M b) { return _kandn_mask16(b, a); }
  static F keep(M m, F a) { return _mm512_maskz_mov_ps(m, a); }
  static int count(M m) { return __builtin_popcount(static_cast<unsigned>(m)); }
  static M zero_bytes(const unsigned char* p) { return _mm512_testn_epi32_mask(bytes(p), bytes(p)); }
  static void store_bits(unsigned char* p, M a, M b, M c) {
    const I bits = _mm512_or_si512(_mm512_maskz_set1_epi32(a, 1),
                                   _mm512_or_si512(_mm512_maskz_set1_epi32(b, 2), _mm512_maskz_set1_epi32(c, 4)));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm512_cvtepi32_epi8(bits));
  }
  static I seti(int a) { return _mm512_set1_epi32(a); }
  static I to_int(F a) { return _mm512_cvttps_epi32(a); }
  static F to_float(I a) { return _mm512_cvtepi32_ps(a); }
  static I addi(I a, I b) { return _mm512_add_epi32(a, b); }
  static I muli(I a, I b) { return _mm512_mullo_epi32(a, b); }
  static I mini(I a, I b) { return _mm512_min_epi32(a, b); }
  template <int k>
  static F byte(I a) {
    const I moved = k ? _mm512_srli_epi32(a, 8 * k) : a;
    return to_float(k == 3 ? moved : _mm512_and_si512(moved, seti(255)));
  }
  static F gather(const float* base, I bytes) { return _mm512_i32gather_ps(bytes, base, 1); }
  static I gather4(const unsigned char* base, I at) { return _mm512_i32gather_epi32(at, base, 1); }
  /// Loads four bytes at once. For the last bytes the load starts before them.
  static M nonzero_byte(const unsigned char* base, I at, int bytes) {
    const I start = mini(at, seti(bytes - 4));
    const I byte = _mm512_srlv_epi32(gather4(base, start), _mm512_slli_epi32(_mm512_sub_epi32(at, start), 3));
    return _mm512_test_epi32_mask(byte, seti(255));
  }

 private:
  static I bytes(const unsigned char* p) {
    return _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)));
  }
};

}  // namespace

const Kernels avx512 = kernels_of<Avx512>("avx512");

}  // namespace dot::kernel
