#include "agents/control/grid/costmap.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {
namespace {

int remainder_of(int number, int of) {
  const int rest = number % of;
  return rest < 0 ? rest + of : rest;
}

/// Returns the direction of a beam.
Eigen::Vector2d ahead_of(const Pose2& odom_from_scan, const Beam& beam) {
  const double heading = odom_from_scan.heading + beam.bearing_rad;
  return {std::cos(heading), std::sin(heading)};
}

}  // namespace

std::vector<Error> check(const CostmapConfig& config) {
  OutOfBounds out("costmap");
  const auto in = out.section("");
  in("side_m", config.side_m, Low::closed, 1, 20);
  in("cell_m", config.cell_m, Low::closed, 0.02, 0.25);
  in("memory_s", config.memory_s, Low::open, 0, 600);
  in("near_m", config.near_m, Low::closed, 0, 3);
  in("near_s", config.near_s, Low::closed, config.memory_s, 600);
  in("footprint_m", config.footprint_m, Low::open, 0, 2);
  return std::move(out.issues);
}

Costmap::Costmap(const CostmapConfig& config)
    : config_(config),
      side_(static_cast<int>(std::lround(config.side_m / config.cell_m))),
      seen_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {}

Cell Costmap::cell_of(const Eigen::Vector2d& odom_point) const {
  return {static_cast<int>(std::floor(odom_point.x() / config_.cell_m)),
          static_cast<int>(std::floor(odom_point.y() / config_.cell_m))};
}

std::size_t Costmap::index(const Cell& cell) const {
  return static_cast<std::size_t>(remainder_of(cell.row, side_)) * static_cast<std::size_t>(side_) +
         static_cast<std::size_t>(remainder_of(cell.column, side_));
}

bool Costmap::is_kept(const Cell& cell) const {
  const Eigen::Vector2d middle((cell.column + 0.5) * config_.cell_m, (cell.row + 0.5) * config_.cell_m);
  return seen_[index(cell)].state == CellState::occupied && (middle - robot_).norm() <= config_.near_m;
}

void Costmap::clear() {
  for (int row = first_.row; row < first_.row + side_; ++row)
    for (int column = first_.column; column < first_.column + side_; ++column)
      if (!is_kept({column, row})) seen_[index({column, row})] = {};
}

void Costmap::roll_to(const Eigen::Vector2d& middle) {
  const Cell at = cell_of(middle);
  const Cell before = std::exchange(first_, {at.column - side_ / 2, at.row - side_ / 2});
  const auto was_inside = [&](int now, int then) { return now >= then && now < then + side_; };
  for (int row = first_.row; row < first_.row + side_; ++row) {
    for (int column = first_.column; column < first_.column + side_; ++column) {
      if (was_inside(column, before.column) && was_inside(row, before.row)) continue;
      seen_[index({column, row})] = {};
    }
  }
}

void Costmap::note(const Cell& cell, CellState state, SensorTime now) {
  if (cell.column < first_.column || cell.column >= first_.column + side_ || cell.row < first_.row ||
      cell.row >= first_.row + side_)
    return;
  seen_[index(cell)] = {now, state};
}

void Costmap::note_footprint(const Eigen::Vector2d& middle, SensorTime now) {
  const Cell at = cell_of(middle);
  const int reach = static_cast<int>(std::floor(config_.footprint_m / config_.cell_m));
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column)
      if (row * row + column * column <= reach * reach)
        note({at.column + column, at.row + row}, CellState::free, now);
}

void Costmap::take(const Pose2& odom_from_robot, const Scan& scan, SensorTime now) {
  robot_ = odom_from_robot.translation();
  roll_to(robot_);
  const Pose2 odom_from_scan = odom_from_robot * scan.robot_from_scan;
  const Eigen::Vector2d from = odom_from_scan.translation();
  const double step_m = 0.5 * config_.cell_m;
  std::vector<Cell> marks;
  for (const Beam& beam : scan.beams) {
    const Eigen::Vector2d ahead = ahead_of(odom_from_scan, beam);
    const Cell end = cell_of(from + beam.range_m * ahead);
    const bool is_obstacle = beam.kind == Beam::Return::obstacle;
    if (is_obstacle) marks.push_back(end);
    const double clear_m = std::min(beam.clear_m, 1.5 * config_.side_m);
    for (double at_m = scan.clear_from_m; at_m <= clear_m; at_m += step_m) {
      const Cell cell = cell_of(from + at_m * ahead);
      if (is_obstacle && cell == end) break;
      note(cell, CellState::free, now);
    }
  }
  note_footprint(odom_from_robot.translation(), now);
  for (const Cell& mark : marks) note(mark, CellState::occupied, now);
}

OccupancyGrid Costmap::grid(SensorTime now) const {
  OccupancyGrid grid =
      unknown_grid({first_.column * config_.cell_m, first_.row * config_.cell_m, config_.cell_m, side_, side_});
  const Duration memory = from_seconds(config_.memory_s);
  const Duration near_memory = from_seconds(config_.near_s);
  for (int row = 0; row < side_; ++row) {
    for (int column = 0; column < side_; ++column) {
      const Cell cell{first_.column + column, first_.row + row};
      const Seen& seen = seen_[index(cell)];
      if (seen.state == CellState::unknown || now - seen.at > (is_kept(cell) ? near_memory : memory)) continue;
      grid.cells[grid.raster.index({column, row})] = seen.state;
    }
  }
  return grid;
}

}  // namespace weft::agents
