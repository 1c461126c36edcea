#include "tests/bench/topometric/baselines.hpp"

#include <cmath>
#include <cstdlib>
#include <numeric>

namespace weft::bench {

using namespace agents;

namespace {

struct Counts {
  std::vector<int> hits;
  std::vector<int> passes;
};

void cast_line(const Raster& raster, Cell at, const Cell& to, bool passes_end, Counts& counts) {
  const int columns = std::abs(to.column - at.column);
  const int rows = -std::abs(to.row - at.row);
  const int right = at.column < to.column ? 1 : -1;
  const int up = at.row < to.row ? 1 : -1;
  for (int error = columns + rows;;) {
    const bool is_end = at == to;
    if (raster.holds(at) && (!is_end || passes_end)) ++counts.passes[raster.index(at)];
    if (is_end) return;
    const int twice = 2 * error;
    if (twice >= rows) {
      error += rows;
      at.column += right;
    }
    if (twice <= columns) {
      error += columns;
      at.row += up;
    }
  }
}

}  // namespace

OccupancyGrid bresenham_grid(const Raster& raster, const RayCastConfig& config,
                             const std::vector<SeenCloud>& clouds) {
  Counts counts{std::vector<int>(raster.size(), 0), std::vector<int>(raster.size(), 0)};
  for (const SeenCloud& cloud : clouds) {
    for (const SeenCloud::Point& point : cloud.points) {
      const Eigen::Vector3f& camera = cloud.cameras[point.frame];
      const auto z = static_cast<double>(point.at.z());
      if (static_cast<double>((point.at - camera).norm()) > config.range_m) continue;
      if (z > config.body_height_m + config.above_m) continue;
      const Cell from = raster.cell_at(camera.head<2>().cast<double>());
      const Cell to = raster.cell_at(point.at.head<2>().cast<double>());
      const bool is_floor = std::abs(z) < config.floor_m;
      if (!is_floor && raster.holds(to)) ++counts.hits[raster.index(to)];
      if (z > -config.floor_m) cast_line(raster, from, to, is_floor, counts);
    }
  }
  OccupancyGrid grid = unknown_grid(raster);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const int rays = counts.hits[i] + counts.passes[i];
    if (rays < config.n_min) continue;
    grid.cells[i] = counts.hits[i] >= config.tau * rays ? CellState::occupied : CellState::free;
  }
  return grid;
}

void amcl_weigh(const DistanceMap& distances, const Scan& scan, std::size_t beams, double sigma_m,
                ParticleSet& particles) {
  constexpr double hit_share = 0.9;
  constexpr double stray_share = 0.1;
  constexpr double longest_m = 5.0;
  constexpr double farthest_m = 1.0;
  const Raster& raster = distances.raster;
  const double denominator = 2.0 * sigma_m * sigma_m;
  const double stray = 1.0 / longest_m;
  const std::size_t step = std::max<std::size_t>(1, (scan.beams.size() - 1) / (beams - 1));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose2 pose = particles.pose(i);
    double weight = 1.0;
    for (std::size_t k = 0; k < scan.beams.size(); k += step) {
      const Beam& beam = scan.beams[k];
      if (beam.kind == Beam::Return::none) continue;
      const double x = pose.x + beam.range_m * std::cos(pose.heading + beam.bearing_rad);
      const double y = pose.y + beam.range_m * std::sin(pose.heading + beam.bearing_rad);
      const Cell cell = raster.cell_at({x, y});
      const double off_m = raster.holds(cell) ? distances.at(cell) : farthest_m;
      const double likelihood = hit_share * std::exp(-off_m * off_m / denominator) + stray_share * stray;
      weight += likelihood * likelihood * likelihood;
    }
    particles.weight[i] *= weight;
  }
  const double all = std::accumulate(particles.weight.begin(), particles.weight.end(), 0.0);
  for (double& weight : particles.weight) weight /= all;
}

}  // namespace weft::bench
