#include <immintrin.h>

#include <cstdint>

#include "agents/perception/stereo/semi_global.hpp"

namespace weft::agents::semi_global::avx2 {
namespace {

/// Holds 32 bytes, one a lane.
using Bytes = __m256i;

[[gnu::always_inline]] inline Bytes load(const std::uint8_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}

[[gnu::always_inline]] inline void store(std::uint8_t* to, const Bytes& bytes) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), bytes);
}

[[gnu::always_inline]] inline Bytes everywhere(std::uint8_t value) {
  return _mm256_set1_epi8(static_cast<char>(value));
}

[[gnu::always_inline]] inline Bytes counting() {
  return _mm256_setr_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
                          25, 26, 27, 28, 29, 30, 31);
}

[[gnu::always_inline]] inline Bytes plus(const Bytes& a, const Bytes& b) {
  return _mm256_adds_epu8(a, b);
}

[[gnu::always_inline]] inline Bytes minus(const Bytes& a, const Bytes& b) {
  return _mm256_subs_epu8(a, b);
}

[[gnu::always_inline]] inline Bytes lesser(const Bytes& a, const Bytes& b) {
  return _mm256_min_epu8(a, b);
}

[[gnu::always_inline]] inline Bytes either(const Bytes& a, const Bytes& b) {
  return _mm256_or_si256(a, b);
}

/// Returns the bytes one lane further up; the last one of `before` comes in below.
[[gnu::always_inline]] inline Bytes lanes_up(const Bytes& bytes, const Bytes& before) {
  return _mm256_alignr_epi8(bytes, _mm256_permute2x128_si256(before, bytes, 0x21), 15);
}

/// Returns the bytes one lane further down; the first one of `after` comes in above.
[[gnu::always_inline]] inline Bytes lanes_down(const Bytes& bytes, const Bytes& after) {
  return _mm256_alignr_epi8(_mm256_permute2x128_si256(bytes, after, 0x21), bytes, 1);
}

/// Returns the least lane's value in all lanes.
[[gnu::always_inline]] inline Bytes least_lane(const Bytes& bytes) {
  const __m128i half = _mm_min_epu8(_mm256_castsi256_si128(bytes), _mm256_extracti128_si256(bytes, 1));
  const __m128i pairs = _mm_min_epu8(half, _mm_srli_epi16(half, 8));  // 16 bits each, the upper ones 0
  return _mm256_broadcastb_epi8(_mm_minpos_epu16(pairs));
}

[[gnu::always_inline]] inline std::uint8_t first_lane(const Bytes& bytes) {
  return static_cast<std::uint8_t>(_mm256_cvtsi256_si32(bytes));
}

/// Returns a bit for each lane in which the two are equal.
[[gnu::always_inline]] inline std::uint32_t lanes_equal(const Bytes& a, const Bytes& b) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_cmpeq_epi8(a, b)));
}

/// Returns `then` where a and b are equal, else `otherwise`.
[[gnu::always_inline]] inline Bytes where_equal(const Bytes& a, const Bytes& b, const Bytes& then,
                                                const Bytes& otherwise) {
  return _mm256_blendv_epi8(otherwise, then, _mm256_cmpeq_epi8(a, b));
}

/// Returns how many of four bits differ, by a table of sixteen.
[[gnu::always_inline]] inline Bytes bits_that_differ(const Bytes& a, const Bytes& b) {
  const Bytes bits = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4, 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2,
                                      3, 2, 3, 3, 4);
  return _mm256_shuffle_epi8(bits, _mm256_xor_si256(a, b));
}

#include "agents/perception/stereo/semi_global_body.hpp"

}  // namespace

void match_row(const Row& row) {
  match(row);
}

}  // namespace weft::agents::semi_global::avx2
