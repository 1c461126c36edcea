#include "agents/bodies/sim/floor/floor_window.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr std::size_t kTileBytes = std::size_t{kTileTexels} * kTileTexels * 4 / 3 + 64;

}  // namespace

FloorWindow::FloorWindow(std::shared_ptr<const FloorSource> source, const std::array<double, kLevels>& reach_m,
                         std::size_t budget_bytes)
    : levels_(levels_from(reach_m)),
      cache_(std::move(source), std::max(2 * kTileBytes, budget_bytes - std::min(budget_bytes, window_bytes()))) {}

std::array<FloorWindow::Level, kLevels> FloorWindow::levels_from(const std::array<double, kLevels>& reach_m) {
  std::array<Level, kLevels> levels;
  for (std::size_t l = 0; l < kLevels; ++l) {
    Level& level = levels[l];
    level.tile_side = kTileTexels >> l;
    if (reach_m[l] <= 0.0) {
      continue;
    }
    // What reaches over n tile lengths touches up to n + 1 tiles.
    level.tiles = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(reach_m[l] / kTileM)) + 1U));
    level.pairs.resize(level.side() / kStripTexels * level.strip_bytes());
    level.holding.resize(static_cast<std::size_t>(level.tiles) * static_cast<std::size_t>(level.tiles));
  }
  return levels;
}

void FloorWindow::need(int level_index, TileKey key) {
  Level& level = levels_[static_cast<std::size_t>(level_index)];
  const int mask = level.tiles - 1;
  auto& holds = level.holding[static_cast<std::size_t>((key.y & mask) * level.tiles + (key.x & mask))];
  if (holds != key) {
    place(level, cache_.tile(key).levels[static_cast<std::size_t>(level_index)], key);
    holds = key;
  }
}

void FloorWindow::place(Level& level, const std::vector<std::uint8_t>& tile, TileKey key) {
  const int mask = level.tiles - 1;
  const auto tile_side = static_cast<std::size_t>(level.tile_side);
  const std::size_t side = level.side();
  const std::size_t strips = side / kStripTexels;
  const std::size_t first = static_cast<std::size_t>(key.x & mask) * tile_side / kStripTexels;
  const std::size_t y0 = static_cast<std::size_t>(key.y & mask) * tile_side;
  for (std::size_t s = 0; s < tile_side / kStripTexels; ++s) {
    std::uint8_t* const strip = level.pairs.data() + (first + s) * level.strip_bytes();
    std::uint8_t* const before = level.pairs.data() + (first + s + strips - 1) % strips * level.strip_bytes();
    for (std::size_t j = 0; j < tile_side; ++j) {
      const std::uint8_t* const from = tile.data() + j * tile_side + s * kStripTexels;
      const std::size_t own = (y0 + j) * kStripRowBytes;
      const std::size_t above = (y0 + j + side - 1) % side * kStripRowBytes + 1;
      for (std::size_t i = 0; i < kStripTexels; ++i) {
        strip[own + 2 * i] = from[i];
        strip[above + 2 * i] = from[i];
      }
      before[own + 2 * kStripTexels] = from[0];
      before[above + 2 * kStripTexels] = from[0];
    }
  }
}

LevelPixels FloorWindow::level(int level_index, TileKey origin) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const int mask = level.tiles - 1;
  LevelPixels pixels;
  pixels.pairs = level.pairs.data();
  pixels.strip_bytes = static_cast<int>(level.strip_bytes());
  pixels.mask = level.tiles * level.tile_side - 1;
  pixels.x0 = (origin.x & mask) * level.tile_side;
  pixels.y0 = (origin.y & mask) * level.tile_side;
  pixels.texels_per_m = static_cast<float>(1.0 / (kTexelM * (1 << level_index)));
  return pixels;
}

std::size_t FloorWindow::window_bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_) {
    sum += level.pairs.size();
  }
  return sum;
}

std::size_t FloorWindow::bytes() const {
  return window_bytes() + cache_.bytes();
}

}  // namespace weft::agents::sim
