// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "bare_loop.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

namespace dot::bench {

#if defined(__x86_64__) && defined(__GNUC__)

namespace {

// The map from a ray to its pixel, which every kernel has; the image of a point at infinity.
struct Map {
  float fx, fy, cx, cy;
  explicit Map(const kernel::View& v) : fx(v.fx), fy(v.fy), cx(v.cx), cy(v.cy) {}
};

__attribute__((target("avx2,fma"))) void run_avx2(const kernel::Input& in, float (&sums)[27]) {
  const Map m(in.view);
  const unsigned char* corner = in.level.data - in.level.stride - 1;
  const auto* rows = reinterpret_cast<const int*>(corner);
  const int stride = static_cast<int>(in.level.stride), step = stride / 4;
  __m256 sum[27];
#pragma GCC unroll 27
  for (auto& s : sum) s = _mm256_setzero_ps();
  for (int i = 0; i + 8 <= in.points.n; i += 8) {
    const __m256 x = _mm256_loadu_ps(in.points.x + i), y = _mm256_loadu_ps(in.points.y + i);
    const __m256 u = _mm256_fmadd_ps(x, _mm256_set1_ps(m.fx), _mm256_set1_ps(m.cx));
    const __m256 v = _mm256_fmadd_ps(y, _mm256_set1_ps(m.fy), _mm256_set1_ps(m.cy));
    const __m256i at =
        _mm256_add_epi32(_mm256_mullo_epi32(_mm256_cvttps_epi32(v), _mm256_set1_epi32(stride)), _mm256_cvttps_epi32(u));
    const __m256 J[7] = {_mm256_cvtepi32_ps(_mm256_i32gather_epi32(rows, at, 1)),
                         _mm256_cvtepi32_ps(_mm256_i32gather_epi32(rows + step, at, 1)),
                         _mm256_cvtepi32_ps(_mm256_i32gather_epi32(rows + 2 * step, at, 1)),
                         _mm256_cvtepi32_ps(_mm256_i32gather_epi32(rows + 3 * step, at, 1)),
                         _mm256_loadu_ps(in.points.q + i),
                         _mm256_loadu_ps(in.points.sigma_q + i),
                         _mm256_loadu_ps(in.points.intensity + i)};
    int k = 0;
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r)
#pragma GCC unroll 7
      for (int c = r; c < 7; ++c, ++k) sum[k] = _mm256_fmadd_ps(J[r], J[c], sum[k]);
  }
  for (int k = 0; k < 27; ++k) sums[k] = sum[k][0] + sum[k][7];
}

__attribute__((target("avx512f"))) void run_avx512(const kernel::Input& in, float (&sums)[27]) {
  const Map m(in.view);
  const unsigned char* corner = in.level.data - in.level.stride - 1;
  const int stride = static_cast<int>(in.level.stride);
  __m512 sum[27];
#pragma GCC unroll 27
  for (auto& s : sum) s = _mm512_setzero_ps();
  for (int i = 0; i + 16 <= in.points.n; i += 16) {
    const __m512 x = _mm512_loadu_ps(in.points.x + i), y = _mm512_loadu_ps(in.points.y + i);
    const __m512 u = _mm512_fmadd_ps(x, _mm512_set1_ps(m.fx), _mm512_set1_ps(m.cx));
    const __m512 v = _mm512_fmadd_ps(y, _mm512_set1_ps(m.fy), _mm512_set1_ps(m.cy));
    const __m512i at =
        _mm512_add_epi32(_mm512_mullo_epi32(_mm512_cvttps_epi32(v), _mm512_set1_epi32(stride)), _mm512_cvttps_epi32(u));
    const __m512 J[7] = {_mm512_cvtepi32_ps(_mm512_i32gather_epi32(at, corner, 1)),
                         _mm512_cvtepi32_ps(_mm512_i32gather_epi32(at, corner + stride, 1)),
                         _mm512_cvtepi32_ps(_mm512_i32gather_epi32(at, corner + 2 * stride, 1)),
                         _mm512_cvtepi32_ps(_mm512_i32gather_epi32(at, corner + 3 * stride, 1)),
                         _mm512_loadu_ps(in.points.q + i),
                         _mm512_loadu_ps(in.points.sigma_q + i),
                         _mm512_loadu_ps(in.points.intensity + i)};
    int k = 0;
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r)
#pragma GCC unroll 7
      for (int c = r; c < 7; ++c, ++k) sum[k] = _mm512_fmadd_ps(J[r], J[c], sum[k]);
  }
  for (int k = 0; k < 27; ++k) sums[k] = sum[k][0] + sum[k][15];
}

}  // namespace

const BareLoop bare_avx2 = run_avx2, bare_avx512 = run_avx512;

#else
const BareLoop bare_avx2 = nullptr, bare_avx512 = nullptr;
#endif

}  // namespace dot::bench
