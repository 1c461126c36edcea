#include "agents/methods/topometric/way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/control/grid/overlay.hpp"
#include "agents/control/grid/reachable.hpp"
#include "agents/control/grid/window.hpp"

namespace weft::agents {
namespace {

constexpr double kPointsApartM = 0.1;

/// Returns the path's corners with points between them.
std::vector<Eigen::Vector2d> with_points_between(const std::vector<Eigen::Vector2d>& path) {
  std::vector<Eigen::Vector2d> points{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d hop = path[i] - path[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(hop.norm() / kPointsApartM)));
    for (int k = 1; k <= parts; ++k) points.push_back(path[i - 1] + hop * (static_cast<double>(k) / parts));
  }
  return points;
}

/// Says why the way does not lead on from a point, or from the robot where there is none.
std::string_view why_no_further(const LocalPlanConfig& local, const KnownGround& ground, const WayAhead& way,
                                std::size_t next) {
  constexpr std::size_t look_at = 10;  // points: a metre
  const std::size_t end = std::min(way.points.size(), next + look_at);
  const auto known = [&](const Eigen::Vector2d& point) { return ground.chart.at(point) != CellState::unknown; };
  const auto first = way.points.begin() + static_cast<std::ptrdiff_t>(next);
  const auto last = way.points.begin() + static_cast<std::ptrdiff_t>(end);
  if (std::none_of(first, last, known)) return "unknown";
  const DistanceMap charted = clearance_of(ground.charted);
  const RoomToDrive room(charted, local.footprint_m, way.robot);
  const Reachable reachable(room, way.robot);
  const bool leads_on = std::any_of(first, last, [&](const Eigen::Vector2d& point) {
    return known(point) && reachable.reaches(point, local.path.goal_within_m);
  });
  return leads_on ? "blocked" : "no_way";
}

/// Sets how far along the way a local goal lies.
void measure(const WayAhead& way, LocalGoal& goal) {
  goal.along_m = 0.0;
  for (std::size_t i = 1; i <= *goal.point; ++i) goal.along_m += (way.points[i] - way.points[i - 1]).norm();
}

/// Takes a local goal before which the way is blocked back to where the robot still sees what blocks it: nearer than
/// half a metre before its lenses it sees nothing. Removes the goal where the robot is that near already: it would
/// turn its back on what it has to look at.
void stand_off(const WayAhead& way, const Reachable& reachable, double within_m, double at_m, LocalGoal& goal) {
  constexpr double stand_off_m = 0.4;
  const Eigen::Vector2d blocked = way.points[*goal.point];
  while (goal.point && (way.points[*goal.point] - blocked).norm() < stand_off_m)
    goal.point = *goal.point > 0 ? std::optional(*goal.point - 1) : std::nullopt;
  const auto at = goal.point ? reachable.nearest(way.points[*goal.point], within_m) : std::nullopt;
  if (at) {
    goal.at = *at;
    measure(way, goal);
  }
  if (!at || goal.along_m < at_m) goal.point.reset();
}

PlanEvent event_of(std::string_view reason) {
  if (reason == "blocked") return PlanEvent::is_blocked;
  return reason == "unknown" ? PlanEvent::chart_ends : PlanEvent::has_no_way;
}

}  // namespace

WayAhead way_ahead(const std::vector<Pose2>& robot_from_path, const Pose2& chart_from_robot) {
  std::vector<Eigen::Vector2d> path;
  for (const Pose2& pose : robot_from_path) path.push_back(chart_from_robot * pose.translation());
  WayAhead way;
  way.robot = chart_from_robot.translation();
  const std::vector<Eigen::Vector2d> all = with_points_between(path);
  const auto nearest = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return (a - way.robot).squaredNorm() < (b - way.robot).squaredNorm();
  });
  way.points.assign(nearest, all.end());
  way.line = {way.robot, *nearest};
  way.line.insert(way.line.end(), all.begin(), all.end());
  return way;
}

KnownGround known_ground(const OccupancyGrid& chart, const OccupancyGrid* costmap, const Pose2& chart_from_odom,
                         const WayAhead& way, double side_m, double corridor_m) {
  KnownGround ground;
  ground.chart = window_of(chart, way.robot, side_m);
  OccupancyGrid both = costmap != nullptr ? overlaid(ground.chart, *costmap, chart_from_odom) : ground.chart;
  ground.charted = ground.chart;
  if (corridor_m > 0.0) {
    keep_beside(both, way.line, corridor_m);
    keep_beside(ground.charted, way.line, corridor_m);
  }
  ground.clearance = clearance_of(both);
  return ground;
}

LocalGoal find_local_goal(const LocalPlanConfig& local, const PlanConfig& plan, const KnownGround& ground,
                          const WayAhead& way, bool stands) {
  constexpr double end_within_m = 0.15;    // the end itself is meant
  const double at_m = stands ? 0.4 : 0.2;  // nearer than this a local goal is no way ahead
  const RoomToDrive room(ground.clearance, local.footprint_m, way.robot);
  const Reachable reachable(room, way.robot);
  const std::size_t last = way.points.size() - 1;
  LocalGoal goal;
  for (std::size_t i = way.points.size(); i-- > 0;) {
    const double within_m = i == last ? std::min(end_within_m, local.path.goal_within_m) : local.path.goal_within_m;
    if (ground.chart.at(way.points[i]) == CellState::unknown) continue;
    const std::optional<Eigen::Vector2d> at = reachable.nearest(way.points[i], within_m);
    if (!at) continue;
    goal.point = i;
    goal.at = *at;
    break;
  }
  if (goal.point) {
    goal.is_end = *goal.point == last;
    measure(way, goal);
    goal.along_m = std::max(goal.along_m, (way.points[*goal.point] - way.robot).norm());
  }
  goal.event = PlanEvent::has_local_goal;
  if (goal.is_end || (goal.point && goal.along_m >= plan.pending_m)) return goal;
  goal.reason = why_no_further(local, ground, way, goal.point ? *goal.point + 1 : 0);
  if (goal.point && goal.reason == "blocked") stand_off(way, reachable, local.path.goal_within_m, at_m, goal);
  const bool is_there = !goal.point || (goal.at - way.robot).norm() < at_m;
  if (is_there || goal.reason == "unknown") goal.event = event_of(goal.reason);
  if (is_there) goal.point.reset();
  return goal;
}

}  // namespace weft::agents
