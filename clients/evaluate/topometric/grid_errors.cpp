#include "clients/evaluate/topometric/grid_errors.hpp"

#include <cmath>

#include "clients/evaluate/topometric/spread.hpp"

namespace weft::evaluate::topometric {
namespace {

using agents::Cell;
using agents::CellState;
using agents::OccupancyGrid;

constexpr double kNearM = 0.10;
constexpr double kOutlineApartM = 0.05;
constexpr double kAcrossWithinM = 0.4;
constexpr double kBeforeM = 0.15;  // in front of a plain wall, where its floor is still seen

/// Returns whether one of the cells within so much of a point is in that state.
template <class Is>
bool any_around(const OccupancyGrid& grid, const Eigen::Vector2d& at, double within_m, const Is& is) {
  const double cell_m = grid.raster.cell_m;
  const Cell middle = grid.raster.cell_at(at);
  const int reach = static_cast<int>(std::ceil(within_m / cell_m));
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const Cell cell{middle.column + column, middle.row + row};
      const double apart_m = (grid.raster.centre(cell) - at).norm();
      if (apart_m <= within_m && is(grid.at(cell))) return true;
    }
  }
  return false;
}

bool is_known_cell(CellState state) {
  return state != CellState::unknown;
}
bool is_occupied_cell(CellState state) {
  return state == CellState::occupied;
}

void count_cells(const OccupancyGrid& grid, const Pose2& site_from_grid, const TrueHall& hall, GridErrors& errors) {
  for (int row = 0; row < grid.raster.rows; ++row) {
    for (int column = 0; column < grid.raster.columns; ++column) {
      const Cell cell{column, row};
      const CellState state = grid.at(cell);
      if (!is_known_cell(state)) continue;
      const double rim_m = hall.to_rim_m(site_from_grid * grid.raster.centre(cell));
      if (is_occupied_cell(state)) {
        errors.occupied += 1.0;
        errors.right_occupied += std::abs(rim_m) <= kNearM ? 1.0 : 0.0;
      } else {
        errors.free += 1.0;
        errors.free_inside += rim_m < -kNearM ? 1.0 : 0.0;
      }
    }
  }
}

void count_outline(const OccupancyGrid& grid, const Pose2& site_from_grid, const TrueHall& hall, GridErrors& errors) {
  const Pose2 grid_from_site = site_from_grid.inverse();
  for (const OutlinePoint& point : hall.outline(kOutlineApartM)) {
    const Eigen::Vector2d at = grid_from_site * point.in_site;
    const Eigen::Vector2d before = grid_from_site * (point.in_site + kBeforeM * point.outwards).eval();
    const Eigen::Vector2d behind = grid_from_site * (point.in_site - kNearM * point.outwards).eval();
    if (point.is_plain) {
      // Nothing of the wall is ever seen: free ends before it, or it does not.
      if (grid.at(before) != CellState::free) continue;
      errors.known += 1.0;
      errors.found += grid.at(behind) == CellState::free ? 0.0 : 1.0;
      continue;
    }
    if (!any_around(grid, at, kNearM, is_known_cell) || !is_known_cell(grid.at(before))) continue;
    errors.known += 1.0;
    errors.found += any_around(grid, at, kNearM, is_occupied_cell) ? 1.0 : 0.0;
  }
}

/// Notes how far occupied cells lie beyond the face of the wall that they are nearest to.
void measure_across(const OccupancyGrid& grid, const Pose2& site_from_grid, const TrueHall& hall,
                    GridErrors& errors) {
  const std::vector<OutlinePoint> outline = hall.outline(4.0 * kOutlineApartM);
  for (int row = 0; row < grid.raster.rows; ++row) {
    for (int column = 0; column < grid.raster.columns; ++column) {
      const Cell cell{column, row};
      if (!is_occupied_cell(grid.at(cell))) continue;
      const Eigen::Vector2d at = site_from_grid * grid.raster.centre(cell);
      const OutlinePoint* nearest = nullptr;
      double nearest_m = kAcrossWithinM;
      for (const OutlinePoint& point : outline) {
        const double apart_m = (point.in_site - at).norm();
        if (apart_m >= nearest_m) continue;
        nearest_m = apart_m;
        nearest = &point;
      }
      if (nearest != nullptr && !nearest->is_plain)
        errors.across_m.push_back(nearest->outwards.dot(at - nearest->in_site));
    }
  }
}

}  // namespace

void GridErrors::add(const GridErrors& more) {
  occupied += more.occupied;
  right_occupied += more.right_occupied;
  known += more.known;
  found += more.found;
  free_inside += more.free_inside;
  free += more.free;
  across_m.insert(across_m.end(), more.across_m.begin(), more.across_m.end());
}

GridErrors grid_errors(const OccupancyGrid& grid, const Pose2& site_from_grid, const TrueHall& hall) {
  GridErrors errors;
  count_cells(grid, site_from_grid, hall, errors);
  count_outline(grid, site_from_grid, hall, errors);
  measure_across(grid, site_from_grid, hall, errors);
  return errors;
}

double thickness_m(const std::vector<double>& across_m) {
  return quantile(across_m, 0.95) - quantile(across_m, 0.05);
}

}  // namespace weft::evaluate::topometric
