#include <immintrin.h>

#include <cstddef>

#include "agents/bodies/sim/floor/kernels.hpp"

namespace weft::agents::sim::avx2 {
namespace {

#include "agents/bodies/sim/floor/kernels_body.hpp"

/// Bilinear samples at eight points, metres from the sampling origin.
__m256 sample(const LevelPixels& level, __m256 x_m, __m256 y_m) {
  const __m256 per_m = _mm256_set1_ps(level.texels_per_m);
  const __m256 half = _mm256_set1_ps(0.5F);
  const __m256 u = _mm256_sub_ps(_mm256_mul_ps(x_m, per_m), half);
  const __m256 v = _mm256_sub_ps(_mm256_mul_ps(y_m, per_m), half);
  const __m256 u_floor = _mm256_floor_ps(u);
  const __m256 v_floor = _mm256_floor_ps(v);
  const __m256 fu = _mm256_sub_ps(u, u_floor);
  const __m256 fv = _mm256_sub_ps(v, v_floor);
  const __m256i mask = _mm256_set1_epi32(level.mask);
  const __m256i x =
      _mm256_and_si256(_mm256_add_epi32(_mm256_cvttps_epi32(u_floor), _mm256_set1_epi32(level.x0)), mask);
  const __m256i y =
      _mm256_and_si256(_mm256_add_epi32(_mm256_cvttps_epi32(v_floor), _mm256_set1_epi32(level.y0)), mask);
  const __m256i strip = _mm256_mullo_epi32(_mm256_srli_epi32(x, kStripLog2), _mm256_set1_epi32(level.strip_bytes));
  const __m256i row = _mm256_mullo_epi32(y, _mm256_set1_epi32(kStripRowBytes));
  const __m256i across = _mm256_slli_epi32(_mm256_and_si256(x, _mm256_set1_epi32(kStripTexels - 1)), 1);
  const __m256i at = _mm256_add_epi32(_mm256_add_epi32(strip, row), across);
  const __m256i four = _mm256_i32gather_epi32(reinterpret_cast<const int*>(level.pairs), at, 1);
  const __m256i byte = _mm256_set1_epi32(255);
  const __m256 t0 = _mm256_cvtepi32_ps(_mm256_and_si256(four, byte));
  const __m256 b0 = _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srli_epi32(four, 8), byte));
  const __m256 t1 = _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srli_epi32(four, 16), byte));
  const __m256 b1 = _mm256_cvtepi32_ps(_mm256_srli_epi32(four, 24));
  const __m256 t = _mm256_add_ps(t0, _mm256_mul_ps(fu, _mm256_sub_ps(t1, t0)));
  const __m256 b = _mm256_add_ps(b0, _mm256_mul_ps(fu, _mm256_sub_ps(b1, b0)));
  return _mm256_add_ps(t, _mm256_mul_ps(fv, _mm256_sub_ps(b, t)));
}

__m256 linear(const float* m, __m256 x, __m256 y) {
  return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(_mm256_set1_ps(m[0]), x), _mm256_mul_ps(_mm256_set1_ps(m[1]), y)),
                       _mm256_set1_ps(m[2]));
}

void sample_row(const RowJob& job) {
  for (int i = 0; i < job.count; i += 8) {
    const __m256 x = _mm256_loadu_ps(job.ray_x + i);
    const __m256 y = _mm256_loadu_ps(job.ray_y + i);
    __m256 sum = _mm256_setzero_ps();
    for (int k = 0; k < kSubsamples; ++k) {
      const FloorFromRay& h = *job.floor_from_ray[k];
      const __m256 w = _mm256_max_ps(linear(h.m + 6, x, y), _mm256_set1_ps(h.least_w));
      const __m256 inverse = _mm256_div_ps(_mm256_set1_ps(1.0F), w);
      const __m256 floor_x = _mm256_mul_ps(linear(h.m, x, y), inverse);
      const __m256 floor_y = _mm256_mul_ps(linear(h.m + 3, x, y), inverse);
      sum = _mm256_add_ps(sum, sample(*job.level[k], floor_x, floor_y));
    }
    _mm256_storeu_ps(job.out + i, _mm256_mul_ps(sum, _mm256_set1_ps(1.0F / kSubsamples)));
  }
}

}  // namespace

Kernels make_kernels() {
  return {sample_row, shade_row, halve, add_noise_row, double_row};
}

}  // namespace weft::agents::sim::avx2
