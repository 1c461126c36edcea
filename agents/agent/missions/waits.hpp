#pragma once
#include <chrono>
#include <cstdint>

#include "core/time.hpp"

namespace weft::agents {

/// Bounds the wait for a piece of the map; then what there is has to do.
inline constexpr Duration kMapAtMost = std::chrono::seconds(20);
/// Bounds a robot's search for where it is; then the search was in vain.
inline constexpr Duration kSearchAtMost = std::chrono::seconds(60);
/// Sets how far the map reaches around a seed before the robot looks for itself there, in hops.
inline constexpr std::uint32_t kSeedHops = 3;

}  // namespace weft::agents
