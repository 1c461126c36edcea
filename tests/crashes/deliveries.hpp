#pragma once
#include <cstdint>

#include "tests/storage/sample_map.hpp"

namespace weft::crashes {

inline constexpr std::uint32_t kProducers = 8;
inline constexpr std::uint32_t kPlaces = 4;  ///< a batch

ExperienceId experience_of(std::uint32_t producer);

/// Returns batch number `sequence` of a producer; the same for the same seed. Its first content is one of a few that
/// all producers send again and again.
storage::sample::Delivery delivery_of(std::uint64_t seed, std::uint32_t producer, std::uint64_t sequence);

}  // namespace weft::crashes
