#pragma once
#include <cmath>
#include <cstdint>

#include "agents/bodies/sim/floor/source.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Calls `draw(random, x, y)` for each thing whose cell of `cell_m` lies within `reach_m` of the tile: the same
/// things whichever tile asks. Each stream holds others, `per_m2` of them a square metre.
template <class Draw>
void scatter(std::uint64_t seed, std::uint64_t stream, double per_m2, double cell_m, double reach_m, TileKey key,
             Draw&& draw) {
  if (per_m2 <= 0.0) {
    return;
  }
  const auto first = [&](int tile) {
    return static_cast<std::int64_t>(std::floor((tile * kTileM - reach_m) / cell_m));
  };
  const auto last = [&](int tile) {
    return static_cast<std::int64_t>(std::floor(((tile + 1) * kTileM + reach_m) / cell_m));
  };
  for (std::int64_t j = first(key.y); j <= last(key.y); ++j) {
    for (std::int64_t i = first(key.x); i <= last(key.x); ++i) {
      Random random((seed * 8 + stream) * 0x9E3779B97F4A7C15ULL ^
                    static_cast<std::uint64_t>(i) * 0xC2B2AE3D27D4EB4FULL ^
                    static_cast<std::uint64_t>(j) * 0x165667B19E3779F9ULL);
      // How many a cell holds: the mean, rounded by chance.
      for (int n = static_cast<int>(std::floor(per_m2 * cell_m * cell_m + random.uniform())); n > 0; --n) {
        const double x = (static_cast<double>(i) + random.uniform()) * cell_m;
        const double y = (static_cast<double>(j) + random.uniform()) * cell_m;
        Random own = random.fork(static_cast<std::uint64_t>(n));
        draw(own, x, y);
      }
    }
  }
}

}  // namespace weft::agents::sim
