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
  bool has_smaller = false;  // cells that hold some of its points
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
    has_smaller = has_smaller || part.has_smaller;
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

/// Returns a spread widened along the ray of a cell to at least what depth is off by there.
Eigen::Matrix3d widened(const Eigen::Matrix3d& spread, const Eigen::Vector3d& from_camera, const DepthNoise& noise) {
  const double range_m = from_camera.norm();
  const double sigma_m = noise.sigma_m(range_m);
  if (sigma_m <= 0.0 || range_m <= 0.0) return spread;
  const Eigen::Vector3d ray = from_camera / range_m;
  return spread + std::max(0.0, sigma_m * sigma_m - ray.dot(spread * ray)) * ray * ray.transpose();
}

/// Returns the normal distribution of a cell's points. The normal is that of the points as they are: one of the
/// widened spread leans to where a wall is seen from, in two clouds alike, as if it told how far along the wall is.
/// The variance across the surface has what its tilt makes of the cell's own size; the tilt is as uncertain as the
/// spread across is large beside that along.
NdtCell cell_from(const CellSums& sums, double cell_m, const DepthNoise& noise, const NdtCellConfig& config) {
  const Eigen::Vector3d mean = sums.points / sums.count;
  const Eigen::Matrix3d products = sums.products.selfadjointView<Eigen::Lower>();
  const Eigen::Matrix3d spread = products / sums.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(spread);
  const Eigen::Vector3d normal = axes.eigenvectors().col(0);
  const double least = config.least_sigma_m * config.least_sigma_m;
  Eigen::Matrix3d covariance = widened(spread, mean - sums.cameras / sums.count, noise);
  covariance.diagonal().array() += least;
  const double across = normal.dot(covariance * normal);
  const double tilt_variance = config.tilt_share * across / std::max(axes.eigenvalues()[1], least);
  return {mean,
          covariance,
          normal,
          across + tilt_variance * cell_m * cell_m / 12.0,
          spread / sums.count,
          !sums.has_smaller};
}

/// Returns whether depth is exact enough there for cells of this size.
bool is_thin(const CellSums& sums, double cell_m, const DepthNoise& noise, const NdtCellConfig& config) {
  const double range_m = (sums.points - sums.cameras).norm() / sums.count;
  return noise.sigma_m(range_m) <= config.thickest * cell_m;
}

/// Makes the cells of a grid, and notes in its sums which have become some.
NdtLevel level_from(Grid& grid, const DepthNoise& noise, const NdtCellConfig& config) {
  NdtLevel level{grid.cell_m, grid.origin, CellTable(grid.table.size()), {}};
  level.cells.reserve(grid.sums.size());
  for (std::size_t number = 0; number < grid.sums.size(); ++number) {
    CellSums& sums = grid.sums[number];
    if (sums.count < config.least_points || !is_thin(sums, grid.cell_m, noise, config)) continue;
    level.table.number_of(grid.table.cells()[number]);
    level.cells.push_back(cell_from(sums, grid.cell_m, noise, config));
    sums.has_smaller = true;
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
