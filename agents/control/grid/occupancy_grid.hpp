#pragma once
#include <cstdint>
#include <vector>

#include "agents/perception/raster.hpp"

namespace weft::agents {

/// Tells what is known of a cell of a grid.
enum class CellState : std::uint8_t { unknown, free, occupied };

/// Holds what is known of each cell of a raster. What is outside is unknown.
struct OccupancyGrid {
  Raster raster;
  std::vector<CellState> cells;  ///< as many as the raster's, row by row

  CellState at(const Cell& cell) const { return raster.holds(cell) ? cells[raster.index(cell)] : CellState::unknown; }
  CellState at(const Eigen::Vector2d& point) const { return at(raster.cell_at(point)); }
};

/// Returns a grid of which nothing is known.
inline OccupancyGrid unknown_grid(const Raster& raster) {
  return {raster, std::vector<CellState>(raster.size(), CellState::unknown)};
}

}  // namespace weft::agents
