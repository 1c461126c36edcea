#pragma once
#include <array>
#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"

namespace weft::agents::sim {

/// Counts the levels of a tile, itself and its area-averaged halvings; level l has kTileTexels >> l texels a side.
inline constexpr int kLevels = 5;
struct FloorTile {
  std::array<std::vector<std::uint8_t>, kLevels> levels;
  std::size_t bytes() const;
};

/// Keeps tiles made on demand, the least recently used thrown away; never more than `limit_bytes`.
class TileCache {
 public:
  /// Begins empty; `limit_bytes` is at least two tiles.
  TileCache(std::shared_ptr<const FloorSource> source, std::size_t limit_bytes);
  /// Returns the tile, made if it is not there; valid until the next call.
  const FloorTile& tile(TileKey key);
  std::size_t bytes() const { return bytes_; }
  std::size_t made() const { return made_; }

 private:
  struct Entry {
    TileKey key;
    FloorTile tile;
  };
  std::shared_ptr<const FloorSource> source_;
  std::size_t limit_bytes_ = 0;
  std::list<Entry> recent_first_;
  std::map<TileKey, std::list<Entry>::iterator> found_;
  std::size_t bytes_ = 0;
  std::size_t made_ = 0;
};

}  // namespace weft::agents::sim
