#pragma once
#include <array>
#include <optional>
#include <vector>

#include "agents/bodies/sim/floor/kernels.hpp"
#include "agents/bodies/sim/floor/tile_cache.hpp"

namespace weft::agents::sim {

/// Holds the floor around the robot at every level, one wrapping picture a level, which the sampling loop can read
/// without looking tiles up (a clipmap: Tanner, Migdal & Jones 1998).
class FloorWindow {
 public:
  /// Reserves the windows. `reach_m`: the largest extent along x or y of what one image looks at with each level, 0
  /// where it uses none; `budget_bytes` is for windows and cache together.
  FloorWindow(std::shared_ptr<const FloorSource> source, const std::array<double, kLevels>& reach_m,
              std::size_t budget_bytes);

  /// Brings the tile into the window, in place of the one that lies a whole number of window lengths away.
  void need(int level, TileKey key);
  /// Returns the pixels to sample around tile `origin`; its lower corner is the origin of sampling coordinates.
  LevelPixels level(int level, TileKey origin) const;
  std::size_t bytes() const;
  const TileCache& cache() const { return cache_; }

 private:
  struct Level {
    int tiles = 0;      ///< a side; power of two, or none
    int tile_side = 0;  ///< texels
    std::size_t side() const { return static_cast<std::size_t>(tiles) * static_cast<std::size_t>(tile_side); }
    std::size_t strip_bytes() const { return side() * kStripRowBytes; }
    std::vector<std::uint8_t> pairs;              ///< as LevelPixels
    std::vector<std::optional<TileKey>> holding;  ///< of each slot
  };
  static std::array<Level, kLevels> levels_from(const std::array<double, kLevels>& reach_m);
  static void place(Level& level, const std::vector<std::uint8_t>& tile, TileKey key);
  std::size_t window_bytes() const;

  std::array<Level, kLevels> levels_;
  TileCache cache_;
};

}  // namespace weft::agents::sim
