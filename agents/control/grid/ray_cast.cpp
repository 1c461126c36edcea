#include "agents/control/grid/ray_cast.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {

std::vector<Error> check(const RayCastConfig& config) {
  OutOfBounds out("ray_cast");
  const auto in = out.section("");
  in("n_min", config.n_min, Low::closed, 1, 1000);
  in("tau", config.tau, Low::open, 0, 1);
  in("range_m", config.range_m, Low::open, 0, 100);
  in("floor_m", config.floor_m, Low::open, 0, 0.5);
  in("body_height_m", config.body_height_m, Low::open, 0, 5);
  in("above_m", config.above_m, Low::closed, 0, 2);
  return std::move(out.issues);
}

RayCaster::RayCaster(const Raster& raster, const RayCastConfig& config)
    : raster_(raster),
      config_(config),
      lines_(static_cast<int>(std::ceil(config.range_m / raster.cell_m)) + 1),
      hits_(raster.size(), 0),
      passes_(raster.size(), 0),
      reach_(static_cast<std::size_t>(lines_.count()) * static_cast<std::size_t>(lines_.steps() + 2), 0),
      longest_(static_cast<std::size_t>(lines_.count()), 0) {}

Result<void> RayCaster::cast(const SeenCloud& cloud) {
  const std::size_t frames = cloud.cameras.size();
  std::vector<std::uint32_t> begins(frames + 1, 0);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const std::size_t frame = cloud.points[i].frame;
    if (frame >= frames)
      return fail(ErrorCode::invalid, "ray_cast: point " + std::to_string(i) + " is of frame " +
                                          std::to_string(frame) + ", but the cloud has " + std::to_string(frames) +
                                          " camera positions; give one a frame");
    ++begins[frame + 1];
  }
  for (std::size_t i = 0; i < frames; ++i) begins[i + 1] += begins[i];
  std::vector<std::uint32_t> order(cloud.points.size());
  std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    order[next[cloud.points[i].frame]++] = static_cast<std::uint32_t>(i);
  for (std::size_t i = 0; i < frames; ++i)
    count_frame(cloud, order.data() + begins[i], order.data() + begins[i + 1], cloud.cameras[i]);
  return {};
}

void RayCaster::count_frame(const SeenCloud& cloud, const std::uint32_t* first, const std::uint32_t* last,
                            const Eigen::Vector3f& camera) {
  if (!camera.allFinite()) return;
  const auto most_square = static_cast<float>(config_.range_m * config_.range_m);
  const auto floor = static_cast<float>(config_.floor_m);
  const auto highest = static_cast<float>(config_.body_height_m + config_.above_m);
  const Cell from = raster_.cell_at(camera.head<2>().cast<double>());
  for (; first != last; ++first) {
    const Eigen::Vector3f& point = cloud.points[*first].at;
    if (!((point - camera).squaredNorm() <= most_square) || point.z() > highest) continue;
    const Cell to = raster_.cell_at(point.head<2>().cast<double>());
    const bool is_floor = std::abs(point.z()) < floor;
    if (!is_floor && raster_.holds(to)) ++hits_[raster_.index(to)];
    if (point.z() > -floor) count_ray(from, to, is_floor);
  }
  walk_lines(from);
}

void RayCaster::count_ray(const Cell& from, const Cell& to, bool is_floor) {
  const CellOffset offset{to.column - from.column, to.row - from.row};
  const int passed = std::min(RayLines::steps_to(offset) + (is_floor ? 1 : 0), lines_.steps() + 1);
  if (passed == 0) return;
  const auto line = static_cast<std::size_t>(lines_.line_to(offset));
  if (longest_[line] == 0) used_.push_back(static_cast<int>(line));
  longest_[line] = std::max(longest_[line], passed);
  ++reach_[line * static_cast<std::size_t>(lines_.steps() + 2) + static_cast<std::size_t>(passed)];
}

void RayCaster::walk_lines(const Cell& from) {
  for (const int line : used_) {
    const RayLines::Walk walk(lines_, line);
    int& longest = longest_[static_cast<std::size_t>(line)];
    std::uint32_t* const reach =
        reach_.data() + static_cast<std::size_t>(line) * static_cast<std::size_t>(lines_.steps() + 2);
    std::uint32_t passing = 0;
    for (int step = longest - 1; step >= 0; --step) {
      passing += std::exchange(reach[step + 1], 0);
      const CellOffset offset = walk.at(step);
      const Cell cell{from.column + offset.columns, from.row + offset.rows};
      if (raster_.holds(cell)) passes_[raster_.index(cell)] += passing;
    }
    longest = 0;
  }
  used_.clear();
}

OccupancyGrid RayCaster::grid() const {
  OccupancyGrid grid = unknown_grid(raster_);
  const auto least = static_cast<std::uint32_t>(config_.n_min);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const std::uint32_t rays = hits_[i] + passes_[i];
    if (rays < least) continue;
    const bool is_occupied = static_cast<double>(hits_[i]) >= config_.tau * static_cast<double>(rays);
    grid.cells[i] = is_occupied ? CellState::occupied : CellState::free;
  }
  return grid;
}

}  // namespace weft::agents
