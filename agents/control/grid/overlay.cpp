#include "agents/control/grid/overlay.hpp"

namespace weft::agents {

OccupancyGrid overlaid(const OccupancyGrid& chart, const OccupancyGrid& costmap, const Pose2& chart_from_odom) {
  OccupancyGrid both = chart;
  const Pose2 odom_from_chart = chart_from_odom.inverse();
  const Raster& raster = chart.raster;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const Cell cell{column, row};
      if (costmap.at(odom_from_chart * raster.centre(cell)) == CellState::free)
        both.cells[raster.index(cell)] = CellState::free;
    }
  }
  const Raster& seen = costmap.raster;
  for (int row = 0; row < seen.rows; ++row) {
    for (int column = 0; column < seen.columns; ++column) {
      if (costmap.cells[seen.index({column, row})] != CellState::occupied) continue;
      const Cell cell = raster.cell_at(chart_from_odom * seen.centre({column, row}));
      if (raster.holds(cell)) both.cells[raster.index(cell)] = CellState::occupied;
    }
  }
  return both;
}

}  // namespace weft::agents
