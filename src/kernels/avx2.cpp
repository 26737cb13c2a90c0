// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// Built with -mavx2 -mfma. Do not include headers of the standard library or of Eigen. The linker could keep the copy
// of their inline functions that is compiled here for the whole program.
#include <immintrin.h>

#include "dot/kernel/impl/kernels_of.hpp"
#include "variants.hpp"

namespace dot::kernel {
namespace {

struct Avx2 {
  static constexpr int W = 8;
  using F = __m256;
  using I = __m256i;
  using M = __m256;

  static F set(float a) { return _mm256_set1_ps(a); }
  static F load(const float* p) { return _mm256_loadu_ps(p); }
  static F load_words(const unsigned short* p) {
    return _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))));
  }
  static void load_pairs(const float* p, F& even, F& odd) {
    const F a = load(p), b = load(p + W), low = _mm256_permute2f128_ps(a, b, 0x20),
            high = _mm256_permute2f128_ps(a, b, 0x31);
    even = _mm256_shuffle_ps(low, high, 0x88), odd = _mm256_shuffle_ps(low, high, 0xdd);
  }
  static void store(float* p, F a) { _mm256_storeu_ps(p, a); }
  static float sum(F a) {
    const __m128 four = _mm_add_ps(_mm256_castps256_ps128(a), _mm256_extractf128_ps(a, 1));
    const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
  }
  static F add(F a, F b) { return _mm256_add_ps(a, b); }
  static F sub(F a, F b) { return _mm256_sub_ps(a, b); }
  static F mul(F a, F b) { return _mm256_mul_ps(a, b); }
  static F div(F a, F b) { return _mm256_div_ps(a, b); }
  static F fma(F a, F b, F c) { return _mm256_fmadd_ps(a, b, c); }
  static F min(F a, F b) { return _mm256_min_ps(a, b); }
  static F max(F a, F b) { return _mm256_max_ps(a, b); }
  static F abs(F a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.f), a); }
  static F inverse_sqrt(F a) {
    // One Newton step from 12 to 23 bits.
    const F y = _mm256_rsqrt_ps(a), ay = mul(a, y);
    return mul(y, _mm256_fnmadd_ps(mul(ay, y), set(0.5f), set(1.5f)));
  }
  static M less(F a, F b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
  static M not_less(F a, F b) { return _mm256_cmp_ps(a, b, _CMP_GE_OQ); }
  static M both(M a, M b) { return _mm256_and_ps(a, b); }
  static M either(M a, M b) { return _mm256_or_ps(a, b); }
  static M without(M a, M b) { return _mm256_andnot_ps(b, a); }
  static F keep(M m, F a) { return _mm256_and_ps(m, a); }
  static int count(M m) { return __builtin_popcount(static_cast<unsigned>(_mm256_movemask_ps(m))); }
  static M zero_bytes(const unsigned char* p) {
    const I a = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)));
    return _mm256_castsi256_ps(_mm256_cmpeq_epi32(a, _mm256_setzero_si256()));
  }
  static void store_bits(unsigned char* p, M a, M b, M c) {
    const auto bit = [](M m, int value) { return _mm256_and_si256(_mm256_castps_si256(m), _mm256_set1_epi32(value)); };
    const I bits = _mm256_or_si256(bit(a, 1), _mm256_or_si256(bit(b, 2), bit(c, 4)));
    const __m128i words = _mm_packs_epi32(_mm256_castsi256_si128(bits), _mm256_extracti128_si256(bits, 1));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_packus_epi16(words, words));
  }
  static I seti(int a) { return _mm256_set1_epi32(a); }
  static I to_int(F a) { return _mm256_cvttps_epi32(a); }
  static F to_float(I a) { return _mm256_cvtepi32_ps(a); }
  static I addi(I a, I b) { return _mm256_add_epi32(a, b); }
  static I muli(I a, I b) { return _mm256_mullo_epi32(a, b); }
  static I mini(I a, I b) { return _mm256_min_epi32(a, b); }
  template <int k>
  static F byte(I a) {
    const I moved = k ? _mm256_srli_epi32(a, 8 * k) : a;
    return to_float(k == 3 ? moved : _mm256_and_si256(moved, seti(255)));
  }
  static F gather(const float* base, I bytes) { return _mm256_i32gather_ps(base, bytes, 1); }
  static I gather4(const unsigned char* base, I at) {
    return _mm256_i32gather_epi32(reinterpret_cast<const int*>(base), at, 1);
  }
  /// Loads four bytes at once. For the last bytes the load starts before them.
  static M nonzero_byte(const unsigned char* base, I at, int bytes) {
    const I start = mini(at, seti(bytes - 4));
    const I byte = _mm256_srlv_epi32(gather4(base, start), _mm256_slli_epi32(_mm256_sub_epi32(at, start), 3));
    const I none = _mm256_cmpeq_epi32(_mm256_and_si256(byte, seti(255)), _mm256_setzero_si256());
    return _mm256_castsi256_ps(_mm256_xor_si256(none, seti(-1)));
  }
};

}  // namespace

const Kernels avx2 = kernels_of<Avx2>("avx2");

}  // namespace dot::kernel
