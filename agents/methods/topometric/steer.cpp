// Steering through what is known to be free (Dayoub et al. 2013, III-D): a local goal on the route, A* and arcs to it
// over chart and costmap, the last bit straight.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "agents/control/grid/local_plan.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/methods/topometric/way_ahead.hpp"

namespace weft::agents {
namespace {

/// Holds all that one decision looks at.
struct SteeringLook {
  const TopometricConfig& config;
  const Ahead& ahead;
  const SteerMemory& memory;
  Pose2 chart_from_robot;
  WayAhead way;
  KnownGround ground;
  Twist moving;
};

/// Holds what came of trying to drive to a local goal.
struct Driven {
  Twist command;
  bool is_turning = false;
  bool has_arrived = false;
};

/// Returns how the robot moves: as it was told, which the base answers late, unless it does otherwise.
Twist moving_now(const SteerMemory& memory, const Ahead& ahead, double since_s) {
  constexpr double recent_s = 0.5;
  constexpr double late_m_s = 0.25;
  if (!memory.is_planned || since_s > recent_s || !memory.steering) return {std::max(0.0, ahead.speed_m_s), 0.0};
  const Twist told = *memory.steering;
  const double speed_m_s = std::clamp(told.linear_m_s, ahead.speed_m_s - late_m_s, ahead.speed_m_s + late_m_s);
  return {std::max(0.0, speed_m_s), told.angular_rad_s};
}

/// Returns how far the robot can go straight to a point.
double straight_free_m(const RoomToDrive& room, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double length_m = (to - from).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / (0.5 * room.clearance().raster.cell_m))));
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    if (!room.allows(from + share * (to - from))) return length_m * static_cast<double>(i - 1) / steps;
  }
  return length_m;
}

/// Drives the last bit of the way straight to its end, slower and slower.
Driven approach(const SteeringLook& look, const RoomToDrive& room, const Eigen::Vector2d& end) {
  constexpr double aside_rad = 0.35;  // more is turned away standing
  constexpr double near_m = 0.1;      // nearer, a bearing says little
  constexpr double gain_rad_1_s = 1.5;
  const TopometricSteerConfig& config = look.config.steer;
  const ArcConfig& arcs = look.config.local.arcs;
  const Eigen::Vector2d left = look.chart_from_robot.inverse() * end;
  const double left_m = std::min(left.norm(), straight_free_m(room, look.way.robot, end));
  const bool has_passed = left.x() <= config.precise_m && left.norm() < near_m;
  if (left_m <= config.precise_m || has_passed) return {{}, false, true};
  const double bearing = std::atan2(left.y(), left.x());
  if (std::abs(bearing) > aside_rad) return {turn_by(arcs, bearing, look.moving.angular_rad_s), true, false};
  const double speed = std::max(config.slowest_m_s, config.gain_1_s * left_m);
  const double turn = gain_rad_1_s * bearing * std::min(1.0, left_m / near_m);
  return {{std::min(speed, look.ahead.speed_limit_m_s), turn}, false, false};
}

/// Returns where the way leads from the robot, in its frame.
double way_bearing(const SteeringLook& look, const std::vector<Eigen::Vector2d>& chart_path) {
  constexpr double ahead_m = 0.5;
  for (const Eigen::Vector2d& point : chart_path) {
    if ((point - look.way.robot).norm() < ahead_m && &point != &chart_path.back()) continue;
    const Eigen::Vector2d to = look.chart_from_robot.inverse() * point;
    return std::atan2(to.y(), to.x());
  }
  return 0.0;
}

/// Drives to a local goal by arcs; turns on the spot first where the way begins beside the robot or behind it.
tl::expected<Driven, NoLocalPlan> drive_to_goal(const SteeringLook& look, const LocalGoal& goal) {
  constexpr double slowly_m_s = 0.05;
  const TopometricConfig& config = look.config;
  const RoomToDrive room(look.ground.clearance, config.local.footprint_m, look.way.robot);
  const double left_m = (goal.at - look.way.robot).norm();
  if (goal.is_end && left_m <= config.steer.precise_from_m) {
    const bool is_free = straight_free_m(room, look.way.robot, goal.at) > left_m - config.local.at_goal_m;
    if (is_free) return approach(look, room, goal.at);
  }
  LocalTask task;
  task.chart_from_robot = look.chart_from_robot;
  task.moving = look.moving;
  task.chart_goal = goal.at;
  task.limit_m_s = std::min(look.ahead.speed_limit_m_s, config.local.arcs.fastest_m_s);
  if (goal.event == PlanEvent::chart_ends) task.limit_m_s = std::min(task.limit_m_s, config.plan.pending_m_s);
  if (goal.is_end)
    task.limit_m_s = std::min(task.limit_m_s, std::max(config.steer.slowest_m_s, config.steer.gain_1_s * left_m));
  const tl::expected<LocalPlan, NoLocalPlan> plan = plan_in_room(config.local, look.ground.clearance, task);
  if (!plan) return tl::unexpected(plan.error());
  if (plan->is_there) return Driven{{}, false, goal.is_end};
  const double bearing = way_bearing(look, plan->chart_path);
  const double most_rad = look.memory.is_turning ? config.steer.turned_rad : config.steer.turn_first_rad;
  const bool is_slow = look.moving.linear_m_s < slowly_m_s;
  if (is_slow && std::abs(bearing) > most_rad)
    return Driven{turn_by(config.local.arcs, bearing, look.moving.angular_rad_s), true, false};
  return Driven{plan->command, false, false};
}

/// Does what the planner says; `since_s`: since the last decision.
Steering act(const TopometricConfig& config, Topometric::Odometry& odometry, PlanEffect effect, const Driven& driven,
             std::string_view reason, double since_s) {
  SteerMemory& memory = odometry.steering;
  memory.is_turning = false;
  switch (effect) {
    case PlanEffect::drive:
    case PlanEffect::drive_slowly:
      memory.turned_rad = 0.0;
      if (!reason.empty()) return tl::unexpected(Stop{reason});
      memory.is_turning = driven.is_turning;
      return driven.command;
    case PlanEffect::plan_globally:
      memory.turned_rad = 0.0;
      return Twist{};
    case PlanEffect::look_around:
      memory.turned_rad += config.plan.recover_rad_s * since_s;
      return Twist{0.0, config.plan.recover_rad_s};
    case PlanEffect::clear_costmap:
      if (odometry.costmap) odometry.costmap->clear();
      break;
    case PlanEffect::stand:
      break;
  }
  return tl::unexpected(Stop{reason});
}

/// Decides anew.
Steering decide(const TopometricConfig& config, Topometric::Odometry& odometry, const Around<Topometric>& around,
                const Ahead& ahead, double since_s) {
  const SteerMemory& memory = odometry.steering;
  SteeringLook look{config, ahead, memory, around.centre_from_robot, {}, {}, moving_now(memory, ahead, since_s)};
  look.way = way_ahead(ahead.robot_from_path, around.centre_from_robot);
  // Distances are of middles of cells, so a cell is left for what is between them; and steering is off its plan.
  constexpr double off_plan_m = 0.06;
  const double left_m = config.chart.cell_m + off_plan_m;
  const double corridor_m = ahead.aside_m > 0.0 ? ahead.aside_m + config.local.footprint_m - left_m : 0.0;
  std::optional<OccupancyGrid> costmap;
  if (odometry.costmap) costmap = odometry.costmap->grid(odometry.time);
  look.ground = known_ground(around.chart->grid, costmap ? &*costmap : nullptr,
                             around.centre_from_robot * project(odometry.odometry_from_robot).inverse(), look.way,
                             config.steer.around_m, corridor_m);
  const bool stands = (memory.is_planned && !memory.steering) || odometry.plan.mode == PlanMode::lost;
  LocalGoal goal = find_local_goal(config.local, config.plan, look.ground, look.way, stands);
  Driven driven;
  if (goal.point) {
    const tl::expected<Driven, NoLocalPlan> tried = drive_to_goal(look, goal);
    if (tried) {
      driven = *tried;
      goal.reason = {};
      if (driven.has_arrived) goal.event = PlanEvent::arrived;
    } else {
      goal.reason = tried.error().reason;
      goal.event = goal.reason == "blocked" ? PlanEvent::is_blocked : PlanEvent::has_no_way;
    }
  }
  const Planned planned = plan_next(config.plan, odometry.plan, goal.event, odometry.time, memory.turned_rad);
  odometry.plan = planned.state;
  return act(config, odometry, planned.effect, driven, goal.reason, since_s);
}

}  // namespace

static_assert(SteersItself<Topometric>);

Steering Topometric::steer(Odometry& odometry, const Around<Topometric>* around, const Ahead& ahead) const {
  SteerMemory& memory = odometry.steering;
  if (around == nullptr || around->chart == nullptr) return tl::unexpected(Stop{"no_chart"});
  if (ahead.robot_from_path.empty()) return tl::unexpected(Stop{"no_way"});
  // Its place may be known well enough by odometry; what stands before it is not.
  if (odometry.blind_m > config_.steer.most_unseen_m) return tl::unexpected(Stop{"blind"});
  constexpr double early = 0.8;  // of a period: samples do not come on the dot
  const double since_s = memory.is_planned ? seconds(odometry.time - memory.at) : config_.local.arcs.period_s;
  if (memory.is_planned && since_s >= 0.0 && since_s < early * config_.local.arcs.period_s) return memory.steering;
  memory.steering = decide(config_, odometry, *around, ahead, std::max(0.0, since_s));
  memory.at = odometry.time;
  memory.is_planned = true;
  return memory.steering;
}

}  // namespace weft::agents
