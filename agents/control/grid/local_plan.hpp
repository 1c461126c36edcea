#pragma once
#include <Eigen/Core>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "agents/control/grid/arcs.hpp"
#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/grid_path.hpp"
#include "agents/control/grid/occupancy_grid.hpp"
#include "core/result.hpp"

namespace weft::agents {

struct LocalPlanConfig {
  double footprint_m = 0.3;     ///< radius of the robot; (0, 2]
  double carrot_m = 0.8;        ///< along the path ahead of the robot; (0, 3]
  double at_goal_m = 0.1;       ///< nearer than this it has arrived; (0, 1]
  double turn_first_rad = 1.0;  ///< a carrot farther off the heading is turned to standing; (0, 3]
  GridPathConfig path;
  ArcConfig arcs;
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const LocalPlanConfig& config);

/// Describes what a plan is made for.
struct LocalTask {
  Pose2 chart_from_robot;
  Pose2 chart_from_odom;
  Twist moving;  ///< now
  Eigen::Vector2d chart_goal = Eigen::Vector2d::Zero();
  double limit_m_s = 0.5;  ///< no faster
};

struct LocalPlan {
  Twist command;
  std::vector<Eigen::Vector2d> chart_path;  ///< from the robot to the goal
  double clear_m = 0.0;                     ///< of the arc that is driven
  bool is_there = false;                    ///< the robot is at the goal
};

/// Says why there is no plan; the robot is to stand.
struct NoLocalPlan {
  std::string_view reason;  ///< "off_the_chart", "no_way" or "blocked": no arc can be driven now
};

/// Plans how to drive to a goal within a chart: a path over the cells that are known to be free in the chart or, of
/// late, in the costmap, then the arc that leads along it (Dayoub et al. 2013, III-D). Of the footprint a circle is
/// kept free. What is unknown is a wall.
tl::expected<LocalPlan, NoLocalPlan> plan_locally(const LocalPlanConfig& config, const OccupancyGrid& chart,
                                                  const OccupancyGrid& costmap, const LocalTask& task);

/// Does the same where it is known already how much room there is around each cell.
tl::expected<LocalPlan, NoLocalPlan> plan_in_room(const LocalPlanConfig& config, const DistanceMap& clearance,
                                                  const LocalTask& task);

/// Returns a turn on the spot by so much, as fast as can still be stopped in time; `now_rad_s` is how fast it turns.
Twist turn_by(const ArcConfig& arcs, double radians, double now_rad_s);

}  // namespace weft::agents
