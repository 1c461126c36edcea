#include "agents/control/grid/window.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace weft::agents {
namespace {

double distance_to_segment_m(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

/// Marks the cells near a segment.
void mark_beside(const Raster& raster, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double within_m,
                 std::vector<std::uint8_t>& is_near) {
  const Eigen::Vector2d reach(within_m, within_m);
  const Cell low = raster.cell_at(from.cwiseMin(to) - reach);
  const Cell high = raster.cell_at(from.cwiseMax(to) + reach);
  for (int row = std::max(low.row, 0); row <= std::min(high.row, raster.rows - 1); ++row) {
    for (int column = std::max(low.column, 0); column <= std::min(high.column, raster.columns - 1); ++column) {
      std::uint8_t& near = is_near[raster.index({column, row})];
      if (near == 0 && distance_to_segment_m(raster.centre({column, row}), from, to) <= within_m) near = 1;
    }
  }
}

}  // namespace

OccupancyGrid window_of(const OccupancyGrid& grid, const Eigen::Vector2d& middle, double side_m) {
  const Raster& raster = grid.raster;
  const int cells = static_cast<int>(std::lround(side_m / raster.cell_m));
  const Cell at = raster.cell_at(middle);
  const Cell first{at.column - cells / 2, at.row - cells / 2};
  OccupancyGrid part = unknown_grid({raster.x_m + first.column * raster.cell_m,
                                     raster.y_m + first.row * raster.cell_m, raster.cell_m, cells, cells});
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column)
      part.cells[part.raster.index({column, row})] = grid.at(Cell{first.column + column, first.row + row});
  return part;
}

void keep_beside(OccupancyGrid& grid, std::span<const Eigen::Vector2d> line, double within_m) {
  std::vector<std::uint8_t> is_near(grid.cells.size(), 0);
  for (std::size_t i = 0; i < line.size(); ++i)
    mark_beside(grid.raster, line[i], line[i + 1 < line.size() ? i + 1 : i], within_m, is_near);
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if (is_near[i] == 0) grid.cells[i] = CellState::unknown;
}

}  // namespace weft::agents
