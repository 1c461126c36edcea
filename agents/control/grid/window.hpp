#pragma once
#include <Eigen/Core>
#include <span>

#include "agents/control/grid/occupancy_grid.hpp"

namespace weft::agents {

/// Returns the part of a grid that lies in a square around a point, cell by cell the same; outside of the grid
/// nothing is known.
OccupancyGrid window_of(const OccupancyGrid& grid, const Eigen::Vector2d& middle, double side_m);

/// Forgets all cells farther than `within_m` from a line of points: what is unknown is a wall to who plans.
void keep_beside(OccupancyGrid& grid, std::span<const Eigen::Vector2d> line, double within_m);

}  // namespace weft::agents
