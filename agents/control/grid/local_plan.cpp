#include "agents/control/grid/local_plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "agents/control/grid/overlay.hpp"
#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {
namespace {

/// Returns the last point of a path before it has led `ahead_m` far that can be driven to straight.
Eigen::Vector2d carrot_on(const std::vector<Eigen::Vector2d>& path, const RoomToDrive& room,
                          const Eigen::Vector2d& robot, double ahead_m) {
  const auto is_straight_free = [&](const Eigen::Vector2d& to) {
    const int steps = static_cast<int>(std::ceil((to - robot).norm() / room.clearance().raster.cell_m));
    for (int i = 1; i < steps; ++i)
      if (!room.allows(robot + (to - robot) * static_cast<double>(i) / static_cast<double>(steps))) return false;
    return true;
  };
  Eigen::Vector2d carrot = path.size() > 1 ? path[1] : path.front();
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size() && length_m < ahead_m; ++i) {
    length_m += (path[i] - path[i - 1]).norm();
    if (!is_straight_free(path[i])) break;
    carrot = path[i];
  }
  return carrot;
}

/// Returns the speed from which the robot comes to stand at the goal.
double speed_before(const ArcConfig& arcs, double left_m) {
  return std::sqrt(2.0 * arcs.deceleration_m_s2 * std::max(left_m, 0.0));
}

/// Returns the arc to a carrot, or a turn towards it.
tl::expected<ChosenArc, NoLocalPlan> drive_to(const LocalPlanConfig& config, const RoomToDrive& room,
                                              const LocalTask& task, const Eigen::Vector2d& carrot, double left_m) {
  constexpr double slowly_m_s = 0.05;
  const Eigen::Vector2d ahead = task.chart_from_robot.inverse() * carrot;
  const double off_rad = std::atan2(ahead.y(), ahead.x());
  if (std::abs(off_rad) > config.turn_first_rad && task.moving.linear_m_s < slowly_m_s)
    return ChosenArc{turn_by(config.arcs, off_rad, task.moving.angular_rad_s), 0.0};
  const bool turns_first = std::abs(off_rad) > config.turn_first_rad;
  const double limit = turns_first ? 0.0 : std::min(task.limit_m_s, speed_before(config.arcs, left_m));
  const ChosenArc arc = choose_arc(config.arcs, room, task.chart_from_robot, task.moving, carrot, limit);
  if (arc.command.linear_m_s > 0.0) return arc;
  constexpr double straight_rad = 0.1;
  if (std::abs(off_rad) > straight_rad)
    return ChosenArc{turn_by(config.arcs, off_rad, task.moving.angular_rad_s), 0.0};
  return tl::unexpected(NoLocalPlan{"blocked"});
}

}  // namespace

Twist turn_by(const ArcConfig& arcs, double radians, double now_rad_s) {
  const double left = std::max(0.0, std::abs(radians) - std::abs(now_rad_s) * arcs.delay_s);
  const double rate = std::min(arcs.fastest_rad_s, std::sqrt(arcs.acceleration_rad_s2 * left));
  const double change = arcs.acceleration_rad_s2 * arcs.period_s;
  return {0.0, std::clamp(std::copysign(rate, radians), now_rad_s - change, now_rad_s + change)};
}

std::vector<Error> check(const LocalPlanConfig& config) {
  OutOfBounds out("local_plan");
  const auto own = out.section("");
  own("footprint_m", config.footprint_m, Low::open, 0, 2);
  own("carrot_m", config.carrot_m, Low::open, 0, 3);
  own("at_goal_m", config.at_goal_m, Low::open, 0, 1);
  own("turn_first_rad", config.turn_first_rad, Low::open, 0, 3);
  const auto path = out.section("path");
  path("comfort_m", config.path.comfort_m, Low::closed, 0, 2);
  path("cost_of_narrow", config.path.cost_of_narrow, Low::closed, 0, 20);
  path("goal_within_m", config.path.goal_within_m, Low::closed, 0, 2);
  const auto arcs = out.section("arcs");
  arcs("fastest_m_s", config.arcs.fastest_m_s, Low::open, 0, 3);
  arcs("acceleration_m_s2", config.arcs.acceleration_m_s2, Low::open, 0, 3);
  arcs("deceleration_m_s2", config.arcs.deceleration_m_s2, Low::open, 0, 3);
  arcs("fastest_rad_s", config.arcs.fastest_rad_s, Low::open, 0, 5);
  arcs("acceleration_rad_s2", config.arcs.acceleration_rad_s2, Low::open, 0, 10);
  arcs("delay_s", config.arcs.delay_s, Low::closed, 0, 1);
  arcs("margin_m", config.arcs.margin_m, Low::closed, 0, 1);
  arcs("period_s", config.arcs.period_s, Low::open, 0, 1);
  arcs("horizon_s", config.arcs.horizon_s, Low::open, 0, 5);
  arcs("speeds", config.arcs.speeds, Low::closed, 2, 100);
  arcs("turns", config.arcs.turns, Low::closed, 3, 101);
  arcs("cost_of_heading_m", config.arcs.cost_of_heading_m, Low::closed, 0, 5);
  arcs("comfort_m", config.arcs.comfort_m, Low::closed, 0, 1);
  arcs("cost_of_narrow", config.arcs.cost_of_narrow, Low::closed, 0, 10);
  return std::move(out.issues);
}

tl::expected<LocalPlan, NoLocalPlan> plan_locally(const LocalPlanConfig& config, const OccupancyGrid& chart,
                                                  const OccupancyGrid& costmap, const LocalTask& task) {
  const Eigen::Vector2d robot = task.chart_from_robot.translation();
  if (!chart.raster.holds(chart.raster.cell_at(robot))) return tl::unexpected(NoLocalPlan{"off_the_chart"});
  return plan_in_room(config, clearance_of(overlaid(chart, costmap, task.chart_from_odom)), task);
}

tl::expected<LocalPlan, NoLocalPlan> plan_in_room(const LocalPlanConfig& config, const DistanceMap& clearance,
                                                  const LocalTask& task) {
  const Eigen::Vector2d robot = task.chart_from_robot.translation();
  if (!clearance.raster.holds(clearance.raster.cell_at(robot))) return tl::unexpected(NoLocalPlan{"off_the_chart"});
  const RoomToDrive room(clearance, config.footprint_m, robot);
  LocalPlan plan;
  const std::optional<std::vector<Eigen::Vector2d>> path = find_path(config.path, room, robot, task.chart_goal);
  if (!path) return tl::unexpected(NoLocalPlan{"no_way"});
  plan.chart_path = *path;
  const double left_m = (path->back() - robot).norm();
  plan.is_there = left_m <= config.at_goal_m;
  if (plan.is_there) return plan;
  const Eigen::Vector2d carrot = carrot_on(*path, room, robot, config.carrot_m);
  const tl::expected<ChosenArc, NoLocalPlan> arc = drive_to(config, room, task, carrot, left_m);
  if (!arc) return tl::unexpected(arc.error());
  plan.command = arc->command;
  plan.clear_m = arc->clear_m;
  return plan;
}

}  // namespace weft::agents
