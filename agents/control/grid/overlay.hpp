#pragma once
#include "agents/control/grid/occupancy_grid.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Returns a chart's grid with what a costmap remembers laid over it: what was seen just now counts more than the
/// chart. Each marked cell of the costmap marks one of the chart, so that nothing thin falls between cells.
OccupancyGrid overlaid(const OccupancyGrid& chart, const OccupancyGrid& costmap, const Pose2& chart_from_odom);

}  // namespace weft::agents
