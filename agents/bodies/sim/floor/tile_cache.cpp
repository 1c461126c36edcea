#include "agents/bodies/sim/floor/tile_cache.hpp"

#include <numeric>

#include "agents/bodies/sim/floor/kernels.hpp"

namespace weft::agents::sim {

std::size_t FloorTile::bytes() const {
  return std::accumulate(levels.begin(), levels.end(), std::size_t{0},
                         [](std::size_t sum, const auto& level) { return sum + level.size(); });
}

TileCache::TileCache(std::shared_ptr<const FloorSource> source, std::size_t limit_bytes)
    : source_(std::move(source)), limit_bytes_(limit_bytes) {}

const FloorTile& TileCache::tile(TileKey key) {
  if (const auto found = found_.find(key); found != found_.end()) {
    recent_first_.splice(recent_first_.begin(), recent_first_, found->second);
    return recent_first_.front().tile;
  }
  Entry entry;
  entry.key = key;
  for (std::size_t l = 0; l < kLevels; ++l) {
    const auto side = static_cast<std::size_t>(kTileTexels >> l);
    entry.tile.levels[l].resize(side * side);
    if (l == 0) {
      source_->fill(key, entry.tile.levels[0]);
    } else {
      kernels().halve(entry.tile.levels[l - 1].data(), static_cast<int>(side), entry.tile.levels[l].data());
    }
  }
  const std::size_t size = entry.tile.bytes();
  while (!recent_first_.empty() && bytes_ + size > limit_bytes_) {
    bytes_ -= recent_first_.back().tile.bytes();
    found_.erase(recent_first_.back().key);
    recent_first_.pop_back();
  }
  recent_first_.push_front(std::move(entry));
  found_[key] = recent_first_.begin();
  bytes_ += size;
  ++made_;
  return recent_first_.front().tile;
}

}  // namespace weft::agents::sim
