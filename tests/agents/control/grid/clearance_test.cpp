#include "agents/control/grid/clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agents/control/grid/overlay.hpp"

namespace weft::agents {
namespace {

const Raster kSmall{-1.0, -0.5, 0.05, 40, 20};

OccupancyGrid free_grid(const Raster& raster) {
  return {raster, std::vector<CellState>(raster.size(), CellState::free)};
}

TEST(DistanceToOccupied, IsThatToTheNearestOfThem) {
  OccupancyGrid grid = unknown_grid(kSmall);
  const Cell first{3, 4};
  const Cell second{30, 17};
  grid.cells[kSmall.index(first)] = grid.cells[kSmall.index(second)] = CellState::occupied;
  const DistanceMap map = distance_to_occupied(grid, 5.0);
  for (int row = 0; row < kSmall.rows; ++row) {
    for (int column = 0; column < kSmall.columns; ++column) {
      const double to_first = std::hypot(column - first.column, row - first.row);
      const double to_second = std::hypot(column - second.column, row - second.row);
      ASSERT_NEAR(map.at(Cell{column, row}), 0.05 * std::min(to_first, to_second), 0.0005) << column << ", " << row;
    }
  }
}

TEST(DistanceToOccupied, IsTheMostWhereNothingStandsOrItIsFar) {
  OccupancyGrid grid = free_grid(kSmall);
  EXPECT_EQ(distance_to_occupied(grid, 0.4).at(Cell{5, 5}), static_cast<double>(0.4F));
  grid.cells[kSmall.index({0, 0})] = CellState::occupied;
  EXPECT_EQ(distance_to_occupied(grid, 0.4).at(Cell{39, 19}), static_cast<double>(0.4F));
}

TEST(Clearance, AnUnknownCellIsAWall) {
  OccupancyGrid grid = free_grid(kSmall);
  const double before = clearance_of(grid).at(Cell{20, 10});
  grid.cells[kSmall.index({22, 10})] = CellState::unknown;
  EXPECT_GT(before, 0.45);
  EXPECT_NEAR(clearance_of(grid).at(Cell{20, 10}), 0.1, 1e-3);
  EXPECT_EQ(clearance_of(grid).at(Cell{22, 10}), 0.0);
}

TEST(Clearance, TheGridEndsInAWall) {
  const DistanceMap map = clearance_of(free_grid(kSmall));
  EXPECT_NEAR(map.at(Cell{0, 10}), 0.05, 1e-3);
  EXPECT_EQ(map.at(Cell{-1, 10}), 0.0);
}

TEST(Overlay, MarksOfTheCostmapCountMoreThanTheChartAndNoneIsLost) {
  OccupancyGrid chart = free_grid(kSmall);
  chart.cells[kSmall.index({10, 10})] = CellState::occupied;
  OccupancyGrid costmap = unknown_grid(square_raster({0.0, 0.0}, 0.5, 0.05));
  for (const Cell mark : {Cell{2, 3}, Cell{7, 7}, Cell{4, 9}})
    costmap.cells[costmap.raster.index(mark)] = CellState::occupied;
  const Pose2 chart_from_odom{0.2, 0.03, 0.7};
  const OccupancyGrid both = overlaid(chart, costmap, chart_from_odom);
  EXPECT_EQ(both.at(Cell{10, 10}), CellState::occupied);
  EXPECT_EQ(std::count(both.cells.begin(), both.cells.end(), CellState::occupied), 4);
  for (const Cell mark : {Cell{2, 3}, Cell{7, 7}, Cell{4, 9}})
    EXPECT_EQ(both.at(chart_from_odom * costmap.raster.centre(mark)), CellState::occupied);
}

TEST(Overlay, WhatWasSeenFreeIsFree) {
  const OccupancyGrid chart = unknown_grid(kSmall);
  const OccupancyGrid costmap = free_grid(square_raster({0.0, 0.0}, 0.5, 0.05));
  const OccupancyGrid both = overlaid(chart, costmap, {0.0, 0.0, 0.3});
  EXPECT_EQ(both.at(Eigen::Vector2d(0.0, 0.0)), CellState::free);
  EXPECT_EQ(both.at(Eigen::Vector2d(0.9, 0.0)), CellState::unknown);
}

}  // namespace
}  // namespace weft::agents
