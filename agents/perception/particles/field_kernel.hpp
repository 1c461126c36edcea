#pragma once
// Private to the likelihood field: its inner loop.
#include <cstdint>
#include <span>

#include "agents/perception/particles/likelihood_field.hpp"

namespace weft::agents {

/// Shows a field as its inner loop has it. Codes are rows of `columns + 2` bytes, `rows + 2` of them, three readable
/// bytes behind; logs are 256 for each width.
struct FieldView {
  const Raster& raster;
  const std::uint8_t* codes;
  const float* logs;
};

/// Adds the log-likelihood of each end for each particle to `logs`, eight particles at once where the processor can
/// (AVX2), else one by one; the sums are the same bit by bit.
void add_logs(const FieldView& field, std::span<const BeamEnd> ends, const ParticleSet& particles,
              std::span<float> logs);
void add_logs_plain(const FieldView& field, std::span<const BeamEnd> ends, const ParticleSet& particles,
                    std::span<float> logs);

}  // namespace weft::agents
