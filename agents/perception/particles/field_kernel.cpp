#include "agents/perception/particles/field_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace weft::agents {
namespace {

constexpr std::size_t kLogs = 256;  // of a width

/// Holds what all particles have in common, so that a point (x, y) lies in column 1 + (x - x0) * by_metre, clamped.
struct Frame {
  float x0, y0, by_metre;
  float last_column, last_row;  ///< of the rim
  std::int32_t wide;
};

Frame frame_of(const Raster& raster) {
  return {static_cast<float>(raster.x_m - raster.cell_m),
          static_cast<float>(raster.y_m - raster.cell_m),
          static_cast<float>(1.0 / raster.cell_m),
          static_cast<float>(raster.columns + 1),
          static_cast<float>(raster.rows + 1),
          raster.columns + 2};
}

struct Turns {
  std::vector<float> sine;
  std::vector<float> cosine;
};

Turns turns_of(const ParticleSet& particles) {
  Turns turns{std::vector<float>(particles.size()), std::vector<float>(particles.size())};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    turns.sine[i] = std::sin(particles.heading[i]);
    turns.cosine[i] = std::cos(particles.heading[i]);
  }
  return turns;
}

/// Returns the log-likelihood of one end for one particle.
float log_of(const FieldView& field, const Frame& frame, const BeamEnd& end, const ParticleSet& particles,
             const Turns& turns, std::size_t i) {
  const float x = particles.x[i] - frame.x0 + (turns.cosine[i] * end.x - turns.sine[i] * end.y);
  const float y = particles.y[i] - frame.y0 + (turns.sine[i] * end.x + turns.cosine[i] * end.y);
  const float column = std::min(std::max(std::floor(x * frame.by_metre), 0.0F), frame.last_column);
  const float row = std::min(std::max(std::floor(y * frame.by_metre), 0.0F), frame.last_row);
  const std::int32_t at = static_cast<std::int32_t>(row) * frame.wide + static_cast<std::int32_t>(column);
  return field.logs[end.width * kLogs + field.codes[at]];
}

void add_from(const FieldView& field, std::span<const BeamEnd> ends, const ParticleSet& particles, const Turns& turns,
              std::span<float> logs, std::size_t first) {
  const Frame frame = frame_of(field.raster);
  for (std::size_t i = first; i < particles.size(); ++i) {
    float sum = logs[i];
    for (const BeamEnd& end : ends) sum += log_of(field, frame, end, particles, turns, i);
    logs[i] = sum;
  }
}

#if defined(__x86_64__)
/// Does whole eights; returns how many particles that were. The operations and their order are those of log_of.
__attribute__((target("avx2"))) std::size_t add_eights(const FieldView& field, std::span<const BeamEnd> ends,
                                                       const ParticleSet& particles, const Turns& turns,
                                                       std::span<float> logs) {
  const Frame frame = frame_of(field.raster);
  const __m256 zero = _mm256_setzero_ps();
  const __m256 by_metre = _mm256_set1_ps(frame.by_metre);
  const __m256 last_column = _mm256_set1_ps(frame.last_column);
  const __m256 last_row = _mm256_set1_ps(frame.last_row);
  const __m256i wide = _mm256_set1_epi32(frame.wide);
  const __m256i byte = _mm256_set1_epi32(0xff);
  const std::size_t count = particles.size() / 8 * 8;
  for (std::size_t i = 0; i < count; i += 8) {
    const __m256 x0 = _mm256_sub_ps(_mm256_loadu_ps(particles.x.data() + i), _mm256_set1_ps(frame.x0));
    const __m256 y0 = _mm256_sub_ps(_mm256_loadu_ps(particles.y.data() + i), _mm256_set1_ps(frame.y0));
    const __m256 sine = _mm256_loadu_ps(turns.sine.data() + i);
    const __m256 cosine = _mm256_loadu_ps(turns.cosine.data() + i);
    __m256 sum = _mm256_loadu_ps(logs.data() + i);
    for (const BeamEnd& end : ends) {
      const __m256 ex = _mm256_set1_ps(end.x);
      const __m256 ey = _mm256_set1_ps(end.y);
      const __m256 x = _mm256_add_ps(x0, _mm256_sub_ps(_mm256_mul_ps(cosine, ex), _mm256_mul_ps(sine, ey)));
      const __m256 y = _mm256_add_ps(y0, _mm256_add_ps(_mm256_mul_ps(sine, ex), _mm256_mul_ps(cosine, ey)));
      const __m256 column =
          _mm256_min_ps(_mm256_max_ps(_mm256_floor_ps(_mm256_mul_ps(x, by_metre)), zero), last_column);
      const __m256 row = _mm256_min_ps(_mm256_max_ps(_mm256_floor_ps(_mm256_mul_ps(y, by_metre)), zero), last_row);
      const __m256i at =
          _mm256_add_epi32(_mm256_mullo_epi32(_mm256_cvttps_epi32(row), wide), _mm256_cvttps_epi32(column));
      const __m256i code =
          _mm256_and_si256(_mm256_i32gather_epi32(reinterpret_cast<const int*>(field.codes), at, 1), byte);
      sum = _mm256_add_ps(sum, _mm256_i32gather_ps(field.logs + end.width * kLogs, code, 4));
    }
    _mm256_storeu_ps(logs.data() + i, sum);
  }
  return count;
}
#endif

}  // namespace

void add_logs(const FieldView& field, std::span<const BeamEnd> ends, const ParticleSet& particles,
              std::span<float> logs) {
  const Turns turns = turns_of(particles);
  std::size_t done = 0;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) done = add_eights(field, ends, particles, turns, logs);
#endif
  add_from(field, ends, particles, turns, logs, done);
}

void add_logs_plain(const FieldView& field, std::span<const BeamEnd> ends, const ParticleSet& particles,
                    std::span<float> logs) {
  add_from(field, ends, particles, turns_of(particles), logs, 0);
}

}  // namespace weft::agents
