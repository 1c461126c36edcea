#include "agents/control/grid/window.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/reachable.hpp"

namespace weft::agents {
namespace {

OccupancyGrid free_square(double side_m) {
  const Raster raster = square_raster({0.0, 0.0}, side_m, 0.05);
  return {raster, std::vector<CellState>(raster.size(), CellState::free)};
}

TEST(GridWindow, KeepsCellsWhereTheyAre) {
  OccupancyGrid grid = free_square(4.0);
  const Eigen::Vector2d marked(1.02, -0.48);
  grid.cells[grid.raster.index(grid.raster.cell_at(marked))] = CellState::occupied;
  const OccupancyGrid window = window_of(grid, {1.0, 0.0}, 2.0);
  EXPECT_EQ(window.raster.columns, 40);
  EXPECT_EQ(window.at(marked), CellState::occupied);
  EXPECT_EQ(window.at(Eigen::Vector2d(1.07, -0.48)), CellState::free);
  EXPECT_EQ(window.at(Eigen::Vector2d(0.97, -0.48)), CellState::free);
}

TEST(GridWindow, KnowsNothingBeyondTheGrid) {
  const OccupancyGrid window = window_of(free_square(4.0), {1.9, 0.0}, 2.0);
  EXPECT_EQ(window.at(Eigen::Vector2d(1.95, 0.0)), CellState::free);
  EXPECT_EQ(window.at(Eigen::Vector2d(2.5, 0.0)), CellState::unknown);
}

TEST(GridCorridor, LeavesWhatLiesNearTheLine) {
  OccupancyGrid grid = free_square(4.0);
  const std::vector<Eigen::Vector2d> line{{-1.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}};
  keep_beside(grid, line, 0.5);
  EXPECT_EQ(grid.at(Eigen::Vector2d(-0.8, 0.42)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(-0.8, 0.58)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.42, 0.8)), CellState::free);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.0, 1.58)), CellState::unknown);
  EXPECT_EQ(grid.at(Eigen::Vector2d(0.4, 1.4)), CellState::unknown) << "its end is round";
}

TEST(Reachable, DoesNotReachBehindAWall) {
  OccupancyGrid grid = free_square(4.0);
  for (int row = 0; row < grid.raster.rows; ++row)
    grid.cells[grid.raster.index({50, row})] = CellState::occupied;  // x from 0.5 m on
  const DistanceMap clearance = clearance_of(grid);
  const RoomToDrive room(clearance, 0.2, {0.0, 0.0});
  const Reachable reachable(room, {0.0, 0.0});
  EXPECT_TRUE(reachable.reaches({-1.0, 1.0}, 0.0));
  EXPECT_FALSE(reachable.reaches({1.0, 0.0}, 0.2));
  EXPECT_FALSE(reachable.reaches({0.45, 0.0}, 0.05)) << "nearer to the wall than its radius";
  EXPECT_TRUE(reachable.reaches({0.45, 0.0}, 0.3));
}

TEST(Reachable, AGapAsWideAsTheRobotIsAWay) {
  OccupancyGrid grid = free_square(4.0);
  for (int row = 0; row < grid.raster.rows; ++row) {
    if (row >= 35 && row < 45) continue;  // half a metre
    grid.cells[grid.raster.index({50, row})] = CellState::occupied;
  }
  const DistanceMap clearance = clearance_of(grid);
  const Reachable narrow(RoomToDrive(clearance, 0.2, {0.0, 0.0}), {0.0, 0.0});
  EXPECT_TRUE(narrow.reaches({1.0, 0.0}, 0.0));
  const Reachable wide(RoomToDrive(clearance, 0.3, {0.0, 0.0}), {0.0, 0.0});
  EXPECT_FALSE(wide.reaches({1.0, 0.0}, 0.0));
}

}  // namespace
}  // namespace weft::agents
