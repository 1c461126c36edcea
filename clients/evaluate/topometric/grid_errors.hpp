#pragma once
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "clients/evaluate/topometric/true_hall.hpp"

/// Judges occupancy grids by what truly stands there. All pure.
namespace weft::evaluate::topometric {

/// Counts how well grids show a site: sums over several are to be added up.
struct GridErrors {
  double occupied = 0.0;        ///< cells
  double right_occupied = 0.0;  ///< of these, within 0.10 m of something's rim
  double known = 0.0;           ///< points of outlines where the grid knows something
  double found = 0.0;        ///< of these, shown within 0.10 m: by an occupied cell; of a plain wall by free's edge
  double free_inside = 0.0;  ///< free cells more than 0.10 m inside of something
  double free = 0.0;
  std::vector<double> across_m;  ///< of occupied cells within 0.4 m of a wall with texture: how far beyond its face

  void add(const GridErrors& more);
};
GridErrors grid_errors(const agents::OccupancyGrid& grid, const Pose2& site_from_grid, const TrueHall& hall);

/// Returns the width of the middle nine tenths of such offsets, metres: how thick walls look.
double thickness_m(const std::vector<double>& across_m);

}  // namespace weft::evaluate::topometric
