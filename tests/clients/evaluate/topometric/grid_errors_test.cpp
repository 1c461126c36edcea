#include "clients/evaluate/topometric/grid_errors.hpp"

#include <gtest/gtest.h>

namespace weft::evaluate::topometric {
namespace {

using agents::Cell;
using agents::CellState;
using agents::OccupancyGrid;
using agents::sim::Box;
using agents::sim::Site;

constexpr double kFaceX = 2.0;

/// Has a wall whose face lies at x = 2.
Site with_wall(double contrast) {
  Site site;
  site.boxes.push_back({Box::Kind::wall, "wall", {kFaceX + 0.5, 0.0, 0.0}, 1.0, 20.0, 2.0, contrast, contrast > 0.5});
  return site;
}

/// Knows what is free up to there, and what is occupied from there on, of a square of 4 m.
OccupancyGrid known_to(double free_to_m, double occupied_from_m, double occupied_to_m) {
  OccupancyGrid grid = agents::unknown_grid(agents::square_raster({1.0, 0.0}, 4.0, 0.05));
  for (int row = 0; row < grid.raster.rows; ++row) {
    for (int column = 0; column < grid.raster.columns; ++column) {
      const Cell cell{column, row};
      const double x = grid.raster.centre(cell).x();
      if (x < free_to_m) grid.cells[grid.raster.index(cell)] = CellState::free;
      if (x >= occupied_from_m && x < occupied_to_m) grid.cells[grid.raster.index(cell)] = CellState::occupied;
    }
  }
  return grid;
}

TEST(GridErrors, AWallThatIsShownWhereItStandsIsRight) {
  const GridErrors errors = grid_errors(known_to(1.95, 1.95, 2.1), {}, TrueHall(with_wall(1.0), 0));
  EXPECT_EQ(errors.right_occupied, errors.occupied);
  EXPECT_GT(errors.known, 60.0);
  EXPECT_EQ(errors.found, errors.known);
  EXPECT_EQ(errors.free_inside, 0.0);
  EXPECT_NEAR(thickness_m(errors.across_m), 0.10, 0.026);
}

TEST(GridErrors, AWallTooFarBackIsNeitherFoundNorRight) {
  const GridErrors errors = grid_errors(known_to(2.25, 2.25, 2.35), {}, TrueHall(with_wall(1.0), 0));
  EXPECT_EQ(errors.right_occupied, 0.0);
  EXPECT_GT(errors.occupied, 0.0);
  EXPECT_GT(errors.known, 60.0);
  EXPECT_EQ(errors.found, 0.0);
  EXPECT_GT(errors.free_inside, 0.0);
}

TEST(GridErrors, APlainWallIsJudgedByTheEdgeOfFree) {
  const TrueHall hall(with_wall(0.02), 0);
  const GridErrors right = grid_errors(known_to(1.95, 9.0, 9.0), {}, hall);
  EXPECT_GT(right.known, 60.0);
  EXPECT_EQ(right.found, right.known);
  const GridErrors through = grid_errors(known_to(2.4, 9.0, 9.0), {}, hall);
  EXPECT_EQ(through.found, 0.0);
  EXPECT_EQ(grid_errors(known_to(1.0, 9.0, 9.0), {}, hall).known, 0.0) << "nothing is said of it";
}

TEST(GridErrors, AreInTheFrameOfTheGrid) {
  const Pose2 site_from_grid{0.0, 0.0, 3.141592653589793};
  const GridErrors errors = grid_errors(known_to(1.95, 1.95, 2.1), site_from_grid, TrueHall(with_wall(1.0), 0));
  EXPECT_EQ(errors.right_occupied, 0.0) << "the wall stands on the other side";
}

}  // namespace
}  // namespace weft::evaluate::topometric
