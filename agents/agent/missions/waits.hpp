#pragma once
#include <chrono>
#include <cstdint>

#include "core/time.hpp"

namespace weft::agents {

/// The longest wait for a piece of the map; then what there is has to do.
inline constexpr Duration kMapAtMost = std::chrono::seconds(20);
/// The longest search of a robot for where it is; then the search was in vain.
inline constexpr Duration kSearchAtMost = std::chrono::seconds(60);
/// The map around a seed before looking for oneself there.
inline constexpr std::uint32_t kSeedHops = 3;

}  // namespace weft::agents
