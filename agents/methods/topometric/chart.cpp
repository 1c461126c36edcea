#include "agents/methods/topometric/chart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "agents/control/grid/clearance.hpp"
#include "agents/methods/topometric/free_space.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {
namespace {

/// Chooses the places whose clouds make the grid, nearest to the centre first.
std::vector<const TopometricPlace*> places_to_cast(const TopometricChartConfig& config,
                                                   const TopometricPlaces& places) {
  std::vector<const TopometricPlace*> near;
  for (const TopometricPlace& place : places) {
    const Eigen::Vector2d at = place.centre_from_place.translation();
    if (place.content && at.cwiseAbs().maxCoeff() <= config.within_m) near.push_back(&place);
  }
  std::stable_sort(near.begin(), near.end(), [](const TopometricPlace* a, const TopometricPlace* b) {
    return a->centre_from_place.translation().squaredNorm() < b->centre_from_place.translation().squaredNorm();
  });
  std::vector<const TopometricPlace*> chosen;
  for (const TopometricPlace* const place : near) {
    if (chosen.size() == static_cast<std::size_t>(config.most_clouds)) break;
    const bool is_shown = std::any_of(chosen.begin(), chosen.end(), [&](const TopometricPlace* other) {
      const Pose2 apart = other->centre_from_place.inverse() * place->centre_from_place;
      return apart.translation().norm() < config.apart_m && std::abs(apart.heading) < config.apart_rad;
    });
    if (!is_shown) chosen.push_back(place);
  }
  return chosen;
}

/// Leaves out points so far from their cameras that what a pair says of their distance makes walls thick. Those
/// without a camera stay, for casting to refuse.
void leave_out_far_points(double within_m, SeenCloud& seen) {
  std::erase_if(seen.points, [&](const SeenCloud::Point& point) {
    return point.frame < seen.cameras.size() &&
           static_cast<double>((point.at - seen.cameras[point.frame]).norm()) > within_m;
  });
}

/// Frees the unknown cells around a point.
void free_around(OccupancyGrid& grid, const Eigen::Vector2d& point, double within_m) {
  const Raster& raster = grid.raster;
  const Cell middle = raster.cell_at(point);
  const int reach = static_cast<int>(std::ceil(within_m / raster.cell_m));
  for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (int column = middle.column - reach; column <= middle.column + reach; ++column) {
      const Cell cell{column, row};
      if (!raster.holds(cell) || (raster.centre(cell) - point).norm() > within_m) continue;
      CellState& state = grid.cells[raster.index(cell)];
      if (state == CellState::unknown) state = CellState::free;
    }
  }
}

/// Frees what robots have driven over when they taught the places.
void free_driven(const TopometricChartConfig& config, const TopometricPlaces& places, OccupancyGrid& grid) {
  if (config.driven_m <= 0.0) return;
  for (const TopometricPlace& place : places) {
    if (!place.content) continue;
    free_around(grid, place.centre_from_place.translation(), config.driven_m);
    for (const Pose3& place_from_frame : place.content->cloud.place_from_frames)
      free_around(grid, (place.centre_from_place * project(place_from_frame)).translation(), config.driven_m);
  }
}

/// Returns what a likelihood field is made of: distances, negative where nothing is known.
std::vector<float> distances_of(const TopometricChartConfig& config, const OccupancyGrid& grid, double most_m) {
  DistanceMap distances = distance_to_occupied(grid, most_m);
  const auto behind = static_cast<float>(config.behind_m);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == CellState::unknown && distances.metres[i] > behind) distances.metres[i] = -1.0F;
  }
  return std::move(distances.metres);
}

std::vector<std::uint32_t> free_cells_of(const OccupancyGrid& grid) {
  std::vector<std::uint32_t> free;
  for (std::uint32_t i = 0; i < grid.cells.size(); ++i)
    if (grid.cells[i] == CellState::free) free.push_back(i);
  return free;
}

}  // namespace

const TopometricPlace* TopometricChart::find(const PlaceId& id) const {
  const auto found =
      std::find_if(places->begin(), places->end(), [&](const TopometricPlace& place) { return place.id == id; });
  return found == places->end() ? nullptr : &*found;
}

DrawPose TopometricChart::anywhere_free() const {
  if (free_cells.empty()) return {};
  return [&free = free_cells, raster = grid.raster](Random& random) {
    const auto cell = static_cast<int>(free[random.below(free.size())]);
    const Eigen::Vector2d at = raster.centre({cell % raster.columns, cell / raster.columns});
    const double half_m = 0.5 * raster.cell_m;
    return Pose2{at.x() + random.uniform(-half_m, half_m), at.y() + random.uniform(-half_m, half_m),
                 random.uniform(-std::numbers::pi, std::numbers::pi)};
  };
}

TopometricChart chart_places(const TopometricChartConfig& config, const RayCastConfig& rays,
                             const LikelihoodConfig& likelihood,
                             const std::vector<ChartPlace<TopometricContent>>& around) {
  auto places = std::make_shared<TopometricPlaces>();
  for (const ChartPlace<TopometricContent>& place : around) {
    if (std::holds_alternative<AlongPath>(place.centre_from_place)) continue;
    places->push_back({place.id, planar(place.centre_from_place), place.content});
  }
  RayCastConfig of_chart = rays;
  of_chart.tau = config.tau;
  RayCaster caster(square_raster({0.0, 0.0}, config.side_m, config.cell_m), of_chart);
  for (const TopometricPlace* const place : places_to_cast(config, *places)) {
    // A cloud whose frames have no camera is not cast; decoding refuses such a content.
    const Pose3 centre_from_place = lift(place->centre_from_place);
    SeenCloud seen = seen_cloud(place->content->cloud, centre_from_place);
    leave_out_far_points(config.seen_within_m, seen);
    add_clear_rays(*place->content, centre_from_place, rays, config.cell_m, seen);
    static_cast<void>(caster.cast(seen));
  }
  OccupancyGrid grid = caster.grid();
  const std::vector<float> metres = distances_of(config, grid, likelihood.most_m);
  free_driven(config, *places, grid);
  LikelihoodField field(likelihood, grid.raster, metres);
  std::vector<std::uint32_t> free = free_cells_of(grid);
  return {std::move(places), std::move(grid), std::move(field), std::move(free)};
}

Topometric::Chart Topometric::chart(const std::vector<ChartPlace<Content>>& around) const {
  return chart_places(config_.chart, config_.rays, config_.filter.likelihood, around);
}

}  // namespace weft::agents
