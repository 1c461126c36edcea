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
    level.stride = 2 * (level.tiles * level.tile_side + 1);
    const auto rows = static_cast<std::size_t>(level.tiles * level.tile_side);
    level.pairs.resize(rows * static_cast<std::size_t>(level.stride));
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
  const auto stride = static_cast<std::size_t>(level.stride);
  const auto side = static_cast<std::size_t>(level.tile_side);
  const std::size_t x0 = static_cast<std::size_t>(key.x & mask) * side;
  const std::size_t y0 = static_cast<std::size_t>(key.y & mask) * side;
  const std::size_t width = static_cast<std::size_t>(level.tiles) * side;
  for (std::size_t j = 0; j < side; ++j) {
    const std::uint8_t* const from = tile.data() + j * side;
    std::uint8_t* const own = level.pairs.data() + (y0 + j) * stride;
    std::uint8_t* const above = level.pairs.data() + (y0 + j + width - 1) % width * stride;
    for (std::size_t i = 0; i < side; ++i) {
      own[2 * (x0 + i)] = from[i];
      above[2 * (x0 + i) + 1] = from[i];
    }
    if (x0 == 0) {
      own[2 * width] = from[0];
      above[2 * width + 1] = from[0];
    }
  }
}

LevelPixels FloorWindow::level(int level_index, TileKey origin) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const int mask = level.tiles - 1;
  LevelPixels pixels;
  pixels.pairs = level.pairs.data();
  pixels.stride = level.stride;
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
