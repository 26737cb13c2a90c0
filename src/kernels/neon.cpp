// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// For AArch64, where every processor has these instructions. See avx2.cpp about included headers.
#include <arm_neon.h>

#include "dot/kernel/impl/kernels_of.hpp"
#include "variants.hpp"

namespace dot::kernel {
namespace {

struct Neon {
  static constexpr int W = 4;
  using F = float32x4_t;
  using I = int32x4_t;
  using M = uint32x4_t;

  static F set(float a) { return vdupq_n_f32(a); }
  static F load(const float* p) { return vld1q_f32(p); }
  static F load_words(const unsigned short* p) { return vcvtq_f32_u32(vmovl_u16(vld1_u16(p))); }
  static void load_pairs(const float* p, F& even, F& odd) {
    const float32x4x2_t pairs = vld2q_f32(p);
    even = pairs.val[0], odd = pairs.val[1];
  }
  static void store(float* p, F a) { vst1q_f32(p, a); }
  static float sum(F a) { return vaddvq_f32(a); }
  static F add(F a, F b) { return vaddq_f32(a, b); }
  static F sub(F a, F b) { return vsubq_f32(a, b); }
  static F mul(F a, F b) { return vmulq_f32(a, b); }
  static F div(F a, F b) { return vdivq_f32(a, b); }
  static F fma(F a, F b, F c) { return vfmaq_f32(c, a, b); }
  // Of a number and a NaN these take the number. vminq and vmaxq would take the NaN.
  static F min(F a, F b) { return vminnmq_f32(a, b); }
  static F max(F a, F b) { return vmaxnmq_f32(a, b); }
  static F abs(F a) { return vabsq_f32(a); }
  static F inverse_sqrt(F a) {
    // Two Newton steps from 8 to 23 bits. vrsqrtsq is (3 - a y y) / 2, also 3/2 for infinity times zero.
    F y = vrsqrteq_f32(a);
    y = mul(y, vrsqrtsq_f32(a, mul(y, y)));
    return mul(y, vrsqrtsq_f32(a, mul(y, y)));
  }
  static M less(F a, F b) { return vcltq_f32(a, b); }
  static M not_less(F a, F b) { return vcgeq_f32(a, b); }
  static M both(M a, M b) { return vandq_u32(a, b); }
  static M either(M a, M b) { return vorrq_u32(a, b); }
  static M without(M a, M b) { return vbicq_u32(a, b); }
  static F keep(M m, F a) { return vreinterpretq_f32_u32(vandq_u32(m, vreinterpretq_u32_f32(a))); }
  static int count(M m) { return -vaddvq_s32(vreinterpretq_s32_u32(m)); }
  static M zero_bytes(const unsigned char* p) {
    unsigned four;
    __builtin_memcpy(&four, p, sizeof four);
    return vceqzq_u32(vmovl_u16(vget_low_u16(vmovl_u8(vcreate_u8(four)))));
  }
  static void store_bits(unsigned char* p, M a, M b, M c) {
    const auto bit = [](M m, unsigned value) { return vandq_u32(m, vdupq_n_u32(value)); };
    const uint16x4_t words = vmovn_u32(vorrq_u32(bit(a, 1), vorrq_u32(bit(b, 2), bit(c, 4))));
    const unsigned four = vget_lane_u32(vreinterpret_u32_u8(vmovn_u16(vcombine_u16(words, words))), 0);
    __builtin_memcpy(p, &four, sizeof four);
  }
  static I seti(int a) { return vdupq_n_s32(a); }
  static I to_int(F a) { return vcvtq_s32_f32(a); }
  static F to_float(I a) { return vcvtq_f32_s32(a); }
  static I addi(I a, I b) { return vaddq_s32(a, b); }
  static I muli(I a, I b) { return vmulq_s32(a, b); }
  static I mini(I a, I b) { return vminq_s32(a, b); }
  /// Converts the byte where it is, as a number with 8 k binary places.
  template <int k>
  static F byte(I a) {
    const uint32x4_t bits = vandq_u32(vreinterpretq_u32_s32(a), vdupq_n_u32(255u << (8 * k)));
    if constexpr (k == 0)
      return vcvtq_f32_u32(bits);
    else
      return vcvtq_n_f32_u32(bits, 8 * k);
  }
  // There are no gathers. Each lane is loaded on its own; an address need not be aligned.
  static F gather(const float* base, I bytes) {
    return vreinterpretq_f32_s32(gather4(reinterpret_cast<const unsigned char*>(base), bytes));
  }
  static I gather4(const unsigned char* base, I at) {
    return I{word(base + at[0]), word(base + at[1]), word(base + at[2]), word(base + at[3])};
  }
  static M nonzero_byte(const unsigned char* base, I at, int) {
    const M bytes = {base[at[0]], base[at[1]], base[at[2]], base[at[3]]};
    return vtstq_u32(bytes, bytes);
  }

 private:
  static int word(const unsigned char* p) {
    int a;
    __builtin_memcpy(&a, p, sizeof a);
    return a;
  }
};

}  // namespace

const Kernels neon = kernels_of<Neon>("neon");

}  // namespace dot::kernel
