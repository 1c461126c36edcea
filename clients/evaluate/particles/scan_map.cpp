#include "clients/evaluate/particles/scan_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/ray_cast.hpp"

namespace weft::evaluate::particles {
namespace {

using namespace agents;

constexpr double kCellM = 0.05;
constexpr double kMarginM = 1.0;
constexpr double kMostCells = 64e6;
constexpr float kHeightM = 0.3F;  // of the laser, anywhere between floor and body

Eigen::Vector2d end_of(const LaserScan& scan, std::size_t i) {
  const auto range = static_cast<double>(scan.ranges_m[i]);
  const double bearing = scan.bearing_rad(i);
  return scan.map_from_laser * Eigen::Vector2d(range * std::cos(bearing), range * std::sin(bearing));
}

bool is_used(float range_m) {
  return range_m > 0.0F && static_cast<double>(range_m) < kRangeM;
}

SeenCloud cloud_of(const LaserScan& scan) {
  SeenCloud cloud;
  const Eigen::Vector2f from = scan.map_from_laser.translation().cast<float>();
  cloud.cameras.emplace_back(from.x(), from.y(), kHeightM);
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    if (!is_used(scan.ranges_m[i])) continue;
    const Eigen::Vector2f end = end_of(scan, i).cast<float>();
    cloud.points.push_back({{end.x(), end.y(), kHeightM}, 0});
  }
  return cloud;
}

Result<Raster> raster_around(const std::vector<SeenCloud>& clouds) {
  constexpr float far = std::numeric_limits<float>::max();
  Eigen::Vector2f low(far, far);
  Eigen::Vector2f high(-far, -far);
  for (const SeenCloud& cloud : clouds) {
    low = low.cwiseMin(cloud.cameras.front().head<2>());
    high = high.cwiseMax(cloud.cameras.front().head<2>());
    for (const SeenCloud::Point& point : cloud.points) {
      low = low.cwiseMin(point.at.head<2>());
      high = high.cwiseMax(point.at.head<2>());
    }
  }
  const Eigen::Vector2d first = low.cast<double>().array() - kMarginM;
  const Eigen::Vector2d cells = ((high.cast<double>().array() + kMarginM - first.array()) / kCellM).ceil();
  if (cells.x() * cells.y() > kMostCells)
    return fail(ErrorCode::exhausted, "the scans lie in " + std::to_string(cells.x() * kCellM) + " by " +
                                          std::to_string(cells.y() * kCellM) +
                                          " m, more than 64 million cells; are the poses corrected ones?");
  return Raster{first.x(), first.y(), kCellM, static_cast<int>(cells.x()), static_cast<int>(cells.y())};
}

}  // namespace

Result<OccupancyGrid> grid_of_even_scans(const std::vector<LaserScan>& scans) {
  std::vector<SeenCloud> clouds;
  for (std::size_t i = 0; i < scans.size(); i += 2) clouds.push_back(cloud_of(scans[i]));
  const Result<Raster> raster = raster_around(clouds);
  if (!raster) return fail(raster.error());
  RayCastConfig config;
  config.range_m = kRangeM;
  config.n_min = 1;  // one ray of a laser does not fly, and far walls are met by few
  RayCaster caster(*raster, config);
  for (const SeenCloud& cloud : clouds)
    if (const Result<void> cast = caster.cast(cloud); !cast) return fail(cast.error());
  OccupancyGrid grid = caster.grid();
  if (std::find(grid.cells.begin(), grid.cells.end(), CellState::free) == grid.cells.end())
    return fail(ErrorCode::invalid, "the scans with even numbers show no free cell: all ranges are 0 or beyond " +
                                        std::to_string(kRangeM) + " m");
  return grid;
}

LikelihoodField field_of(const OccupancyGrid& grid, const LikelihoodConfig& config) {
  DistanceMap distances = distance_to_occupied(grid, config.most_m);
  // Between the rays that met a wall its cells are unknown: so near to what was met, a beam counts by its distance.
  constexpr float near_m = 0.1F;
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if (grid.cells[i] == CellState::unknown && distances.metres[i] > near_m) distances.metres[i] = -1.0F;
  return {config, grid.raster, distances.metres};
}

DrawPose anywhere_free(const OccupancyGrid& grid) {
  const auto places = std::make_shared<std::vector<Eigen::Vector2d>>();
  for (int row = 0; row < grid.raster.rows; ++row)
    for (int column = 0; column < grid.raster.columns; ++column)
      if (grid.cells[grid.raster.index({column, row})] == CellState::free)
        places->push_back(grid.raster.centre({column, row}));
  return [places, cell_m = grid.raster.cell_m](Random& random) {
    const Eigen::Vector2d& place = (*places)[random.below(places->size())];
    return Pose2{place.x() + cell_m * random.uniform(-0.5, 0.5), place.y() + cell_m * random.uniform(-0.5, 0.5),
                 random.uniform(-std::numbers::pi, std::numbers::pi)};
  };
}

Scan scan_of_laser(const LaserScan& scan) {
  Scan made;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    Beam beam;
    beam.bearing_rad = scan.bearing_rad(i);
    if (is_used(scan.ranges_m[i])) {
      beam.kind = Beam::Return::obstacle;
      beam.range_m = beam.clear_m = static_cast<double>(scan.ranges_m[i]);
      beam.sigma_m = kLaserSigmaM;
    }
    made.beams.push_back(beam);
  }
  return made;
}

}  // namespace weft::evaluate::particles
