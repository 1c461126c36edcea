#include "agents/perception/clouds/ndt_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace weft::agents {
namespace {

constexpr std::size_t kMostLevels = 6;  // 0.2 m to 6.4 m
constexpr double kDenseShare = 0.5;

/// Sums up what a cell's distribution is made of; sums of smaller cells add up to those of a larger one.
struct CellSums {
  double count = 0.0;
  Eigen::Vector3d points = Eigen::Vector3d::Zero();
  Eigen::Vector3d cameras = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  // lower triangle

  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& camera) {
    count += 1.0;
    points += point;
    cameras += camera;
    for (int column = 0; column < 3; ++column) {
      for (int row = column; row < 3; ++row) products(row, column) += point[row] * point[column];
    }
  }
  void add(const CellSums& part) {
    count += part.count;
    points += part.points;
    cameras += part.cameras;
    products += part.products;
  }
};

struct Grid {
  double cell_m = 0.0;
  Eigen::Vector3d origin;
  CellTable table;
  std::vector<CellSums> sums;

  CellSums& at(const CellCoordinates& cell) {
    const std::uint32_t number = table.number_of(cell);
    if (number == sums.size()) sums.emplace_back();
    return sums[number];
  }
};

Grid finest_grid(const FramedCloud& cloud, double cell_m) {
  const double per_m = 1.0 / cell_m;
  Grid grid{cell_m, {0.0, 0.0, -0.5 * cell_m}, CellTable(cloud.points.size() / 16), {}};
  for (std::size_t at = 0; at < cloud.points.size(); ++at) {
    const Eigen::Vector3d point = cloud.points[at].cast<double>();
    const Eigen::Vector3d from_origin = point - grid.origin;
    if (is_on_grid(from_origin, per_m)) grid.at(cell_of(from_origin, per_m)).add(point, cloud.camera_of(at));
  }
  return grid;
}

Grid coarser(const Grid& fine) {
  Grid grid{2.0 * fine.cell_m, fine.origin, CellTable(fine.table.size() / 3), {}};
  for (std::size_t number = 0; number < fine.sums.size(); ++number) {
    const CellCoordinates& cell = fine.table.cells()[number];
    grid.at({cell[0] >> 1, cell[1] >> 1, cell[2] >> 1}).add(fine.sums[number]);
  }
  return grid;
}

bool is_dense(const Grid& grid, double least_points) {
  double all = 0.0;
  double dense = 0.0;
  for (const CellSums& sums : grid.sums) {
    all += sums.count;
    if (sums.count >= least_points) dense += sums.count;
  }
  return dense >= kDenseShare * all;
}

/// Widens a spread along the ray of a cell to at least what depth is off by there.
void widen_along_ray(Eigen::Matrix3d& spread, const Eigen::Vector3d& from_camera, const DepthNoise& noise) {
  const double range_m = from_camera.norm();
  const double sigma_m = noise.sigma_m(range_m);
  if (sigma_m <= 0.0 || range_m <= 0.0) return;
  const Eigen::Vector3d ray = from_camera / range_m;
  const double lacking = sigma_m * sigma_m - ray.dot(spread * ray);
  if (lacking > 0.0) spread += lacking * ray * ray.transpose();
}

/// Holds a spread's principal axes, the thinnest first.
struct Axes {
  Eigen::Vector3d variances;
  Eigen::Matrix3d directions;

  explicit Axes(const Eigen::Matrix3d& spread) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(spread);
    variances = solver.eigenvalues();
    directions = solver.eigenvectors();
  }
  Eigen::Matrix3d with(const Eigen::Vector3d& others) const {
    return directions * others.asDiagonal() * directions.transpose();
  }
};

/// Returns the variances of the surface that is matched to. Across it: the spread there, and what its tilt, which is
/// as uncertain as the spread across is large beside that along, makes of the cell's own size.
Eigen::Vector3d without_end(const Eigen::Vector3d& variances, double cell_m, const NdtCellConfig& config) {
  const double along = config.along_surface * config.along_surface * cell_m * cell_m;
  const double tilt = variances[0] / variances[1];
  return {variances[0] + tilt * cell_m * cell_m / 12.0, along, along};
}

NdtCell cell_from(const CellSums& sums, double cell_m, const DepthNoise& noise, const NdtCellConfig& config) {
  const Eigen::Vector3d mean = sums.points / sums.count;
  const Eigen::Matrix3d products = sums.products.selfadjointView<Eigen::Lower>();
  Eigen::Matrix3d spread = products / sums.count - mean * mean.transpose();
  widen_along_ray(spread, mean - sums.cameras / sums.count, noise);
  const Axes axes(spread);
  const Eigen::Vector3d variances = axes.variances.cwiseMax(config.least_sigma_m * config.least_sigma_m);
  return {mean, axes.with(variances), axes.with(without_end(variances, cell_m, config)), spread / sums.count,
          config.tilt_share * variances[0] / variances[1]};
}

/// Returns whether depth is exact enough there for cells of this size.
bool is_thin(const CellSums& sums, double cell_m, const DepthNoise& noise, const NdtCellConfig& config) {
  const double range_m = (sums.points - sums.cameras).norm() / sums.count;
  return noise.sigma_m(range_m) <= config.thickest * cell_m;
}

NdtLevel level_from(const Grid& grid, const DepthNoise& noise, const NdtCellConfig& config) {
  NdtLevel level{grid.cell_m, grid.origin, CellTable(grid.table.size()), {}};
  level.cells.reserve(grid.sums.size());
  for (std::size_t number = 0; number < grid.sums.size(); ++number) {
    const CellSums& sums = grid.sums[number];
    if (sums.count < config.least_points || !is_thin(sums, grid.cell_m, noise, config)) continue;
    level.table.number_of(grid.table.cells()[number]);
    level.cells.push_back(cell_from(sums, grid.cell_m, noise, config));
  }
  return level;
}

}  // namespace

NdtMap ndt_map(const FramedCloud& cloud, const NdtCellConfig& config) {
  NdtMap map;
  Grid grid = finest_grid(cloud, config.finest_m);
  for (std::size_t level = 0; level < kMostLevels; ++level) {
    if (!map.levels.empty() || is_dense(grid, config.least_points)) {
      map.levels.push_back(level_from(grid, cloud.noise, config));
    }
    if (level + 1 < kMostLevels) grid = coarser(grid);
  }
  return map;
}

}  // namespace weft::agents
