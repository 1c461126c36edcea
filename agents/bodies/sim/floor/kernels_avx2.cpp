#include <immintrin.h>

#include <cstddef>

#include "agents/bodies/sim/floor/kernels.hpp"

namespace weft::agents::sim::avx2 {
namespace {

constexpr int kFaceLanes = 4;
#include "agents/bodies/sim/faces_body.hpp"
#include "agents/bodies/sim/floor/kernels_body.hpp"

__m128i two_at(const std::uint8_t* from, std::int64_t places) {
  const auto both = static_cast<std::uint64_t>(places);
  std::int32_t first = 0;
  std::int32_t second = 0;
  __builtin_memcpy(&first, from + (both & 0xffffffffU), sizeof first);
  __builtin_memcpy(&second, from + (both >> 32U), sizeof second);
  return _mm_insert_epi32(_mm_cvtsi32_si128(first), second, 1);
}

/// Loads four bytes from each of eight places, one by one: several processors take long over a gather instruction.
__m256i four_bytes_at(const std::uint8_t* from, __m256i places) {
  const __m128i low = _mm256_castsi256_si128(places);
  const __m128i high = _mm256_extracti128_si256(places, 1);
  return _mm256_set_m128i(
      _mm_unpacklo_epi64(two_at(from, _mm_cvtsi128_si64(high)), two_at(from, _mm_extract_epi64(high, 1))),
      _mm_unpacklo_epi64(two_at(from, _mm_cvtsi128_si64(low)), two_at(from, _mm_extract_epi64(low, 1))));
}

/// Returns bilinear samples at eight points, metres from the sampling origin.
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
  // A step to the right is two bytes, and one into the next strip what its rows take less those two bytes a texel.
  const __m256i strip =
      _mm256_mullo_epi32(_mm256_srli_epi32(x, kStripLog2), _mm256_set1_epi32(level.strip_bytes - 2 * kStripTexels));
  const __m256i row = _mm256_mullo_epi32(y, _mm256_set1_epi32(kStripRowBytes));
  const __m256i at = _mm256_add_epi32(_mm256_add_epi32(strip, row), _mm256_slli_epi32(x, 1));
  const __m256i four = four_bytes_at(level.pairs, at);
  // Of each pair the left in the lower half, the right in the upper: one multiply-add takes their difference.
  const __m256i tops = _mm256_and_si256(four, _mm256_set1_epi32(0x00ff00ff));
  const __m256i bottoms = _mm256_srli_epi16(four, 8);
  const __m256i right_less_left = _mm256_set1_epi32(0x0001ffff);
  const __m256i left = _mm256_set1_epi32(0xffff);
  const __m256 t_slope = _mm256_cvtepi32_ps(_mm256_madd_epi16(tops, right_less_left));
  const __m256 b_slope = _mm256_cvtepi32_ps(_mm256_madd_epi16(bottoms, right_less_left));
  const __m256 t = _mm256_add_ps(_mm256_cvtepi32_ps(_mm256_and_si256(tops, left)), _mm256_mul_ps(fu, t_slope));
  const __m256 b = _mm256_add_ps(_mm256_cvtepi32_ps(_mm256_and_si256(bottoms, left)), _mm256_mul_ps(fu, b_slope));
  return _mm256_add_ps(t, _mm256_mul_ps(fv, _mm256_sub_ps(b, t)));
}

__m256 linear(const float* m, __m256 x, __m256 y) {
  return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(_mm256_set1_ps(m[0]), x), _mm256_mul_ps(_mm256_set1_ps(m[1]), y)),
                       _mm256_set1_ps(m[2]));
}

/// Samples a row, subsample by subsample, so that what belongs to one stays in registers; sums wait in `out`.
void sample_row(const RowJob& job) {
  for (int k = 0; k < kSubsamples; ++k) {
    const FloorFromRay h = *job.floor_from_ray[k];
    const LevelPixels level = *job.level[k];
    const __m256 share = _mm256_set1_ps(k + 1 == kSubsamples ? 1.0F / kSubsamples : 1.0F);
    for (int i = 0; i < job.count; i += 8) {
      const __m256 x = _mm256_loadu_ps(job.ray_x + i);
      const __m256 y = _mm256_loadu_ps(job.ray_y + i);
      const __m256 w = _mm256_max_ps(linear(h.m + 6, x, y), _mm256_set1_ps(h.least_w));
      const __m256 inverse = _mm256_div_ps(_mm256_set1_ps(1.0F), w);
      const __m256 floor_x = _mm256_mul_ps(linear(h.m, x, y), inverse);
      const __m256 floor_y = _mm256_mul_ps(linear(h.m + 3, x, y), inverse);
      const __m256 before = k == 0 ? _mm256_setzero_ps() : _mm256_loadu_ps(job.out + i);
      _mm256_storeu_ps(job.out + i, _mm256_mul_ps(_mm256_add_ps(before, sample(level, floor_x, floor_y)), share));
    }
  }
}

__m256 between(__m256 from, __m256 to, __m256 share) {
  return _mm256_add_ps(from, _mm256_mul_ps(share, _mm256_sub_ps(to, from)));
}

void shade_row(const ShadeJob& job) {
  const float below = job.below;
  const float above = 1.0F - below;
  const __m256 right = _mm256_mul_ps(_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_ps(1.0F / kShadeCell));
  const __m256 noise_scale = _mm256_set1_ps(job.noise_scale);
  const auto at_node = [&](const float* node_above, const float* node_below, int node) {
    return _mm256_set1_ps(above * node_above[node] + below * node_below[node]);
  };
  __m256 gain = at_node(job.gain_above, job.gain_below, 0);
  __m256 add = at_node(job.add_above, job.add_below, 0);
  for (int p = 0; p < job.count; p += kShadeCell) {
    const int next = p / kShadeCell + 1;
    const __m256 next_gain = at_node(job.gain_above, job.gain_below, next);
    const __m256 next_add = at_node(job.add_above, job.add_below, next);
    const __m256 lit = _mm256_mul_ps(_mm256_loadu_ps(job.albedo + p), between(gain, next_gain, right));
    const __m256 noise = _mm256_mul_ps(_mm256_loadu_ps(job.noise + p), noise_scale);
    const __m256 grey = _mm256_add_ps(_mm256_add_ps(lit, between(add, next_add, right)), noise);
    const __m256 rounded = _mm256_add_ps(grey, _mm256_set1_ps(0.5F));
    const __m256 cut = _mm256_min_ps(_mm256_max_ps(rounded, _mm256_setzero_ps()), _mm256_set1_ps(255.0F));
    const __m256i whole = _mm256_cvttps_epi32(cut);
    const __m128i words = _mm_packus_epi32(_mm256_castsi256_si128(whole), _mm256_extracti128_si256(whole, 1));
    _mm_storel_epi64(reinterpret_cast<__m128i*>(job.out + p), _mm_packus_epi16(words, words));
    gain = next_gain;
    add = next_add;
  }
}

}  // namespace

Kernels make_kernels() {
  return {sample_row, shade_row, halve, add_noise_row, double_row, face_row};
}

}  // namespace weft::agents::sim::avx2
