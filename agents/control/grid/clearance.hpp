#pragma once
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"

namespace weft::agents {

/// Holds a distance for each cell of a raster, metres.
struct DistanceMap {
  Raster raster;
  std::vector<float> metres;

  /// Returns the cell's distance; 0 outside.
  double at(const Cell& cell) const {
    return raster.holds(cell) ? static_cast<double>(metres[raster.index(cell)]) : 0.0;
  }
  double at(const Eigen::Vector2d& point) const { return at(raster.cell_at(point)); }
};

/// Returns how far the middle of each cell is from the middle of the nearest occupied one (Euclidean, exact to a
/// hundredth of a cell), at most `most_m`, also where nothing is occupied.
DistanceMap distance_to_occupied(const OccupancyGrid& grid, double most_m);

/// Returns how much room there is around each cell: the distance to the nearest cell that is not known to be free,
/// where what lies outside of the grid is not. An unknown cell is a wall.
DistanceMap clearance_of(const OccupancyGrid& grid);

}  // namespace weft::agents
