#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/local_plan.hpp"
#include "agents/control/grid/occupancy_grid.hpp"
#include "agents/methods/method.hpp"
#include "agents/methods/topometric/plan.hpp"

namespace weft::agents {

/// Holds what is known around the robot, in the frame of the chart.
struct KnownGround {
  OccupancyGrid chart;    ///< as places have shown it
  OccupancyGrid charted;  ///< the same in the corridor alone; beside it nothing is known
  DistanceMap clearance;  ///< of that and what the costmap remembers
};

/// Holds the way ahead in the frame of the chart.
struct WayAhead {
  Eigen::Vector2d robot = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> line;    ///< the corridor's middle: from the robot onto the path, and all of it
  std::vector<Eigen::Vector2d> points;  ///< close to each other, from beside the robot to the end
};
/// Lays out a path that has one pose at least.
WayAhead way_ahead(const std::vector<Pose2>& robot_from_path, const Pose2& chart_from_robot);

/// Returns what is known in a square of `side_m` around the robot. `costmap` may be null. `corridor_m`: what lies
/// farther from the way is left out; 0: nothing is.
KnownGround known_ground(const OccupancyGrid& chart, const OccupancyGrid* costmap, const Pose2& chart_from_odom,
                         const WayAhead& way, double side_m, double corridor_m);

/// Tells how far the way leads now (Dayoub et al. 2013, III-D: the local goal).
struct LocalGoal {
  PlanEvent event = PlanEvent::has_no_way;
  std::string_view reason;           ///< why it does not lead on from there: "blocked", "no_way" or "unknown"
  std::optional<std::size_t> point;  ///< of the way's points: the last one that the chart knows and a way leads to
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< there, or as near to it as there is room
  bool is_end = false;                           ///< that is the end of the way
  double along_m = 0.0;                          ///< to there
};
/// `stands`: it has stopped before; then only a way farther on makes it go on, not the noise of what it sees.
LocalGoal find_local_goal(const LocalPlanConfig& local, const PlanConfig& plan, const KnownGround& ground,
                          const WayAhead& way, bool stands);

}  // namespace weft::agents
