#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "agents/control/grid/room_to_drive.hpp"
#include "agents/perception/motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Bounds what a base can do, and how arcs are judged.
struct ArcConfig {
  double fastest_m_s = 0.5;          ///< (0, 3]
  double acceleration_m_s2 = 0.5;    ///< (0, 3]
  double deceleration_m_s2 = 0.6;    ///< that a stop counts on; (0, 3]
  double fastest_rad_s = 1.0;        ///< (0, 5]
  double acceleration_rad_s2 = 2.0;  ///< (0, 10]
  double delay_s = 0.2;              ///< from a command to what it does, at most; [0, 1]
  double margin_m = 0.05;            ///< kept before what an arc would end in; [0, 1]
  double period_s = 0.1;             ///< between commands; (0, 1]
  double horizon_s = 1.5;            ///< an arc is looked along for so long; (0, 5]
  int speeds = 15;                   ///< samples; [2, 100]
  int turns = 21;                    ///< samples; odd, so that straight on is among them; [3, 101]
  double cost_of_heading_m =
      0.25;                     ///< a radian off the carrot at an arc's end costs as much as this many metres; [0, 5]
  double comfort_m = 0.15;      ///< room beyond the radius that an arc had better keep; [0, 1]
  double cost_of_narrow = 0.5;  ///< metres for a metre of room less than that; [0, 10]
};

/// Describes the arc that was chosen.
struct ChosenArc {
  Twist command;
  double clear_m = 0.0;  ///< of it, as far as it was looked along
};

/// Returns how far a robot comes that is told to stop: v^2 / 2a and what it drives until it answers.
double stop_distance_m(const ArcConfig& config, double speed_m_s);

/// Samples the arcs that the base can drive within its accelerations and chooses the best that leads to the carrot
/// (dynamic window: Fox, Burgard & Thrun 1997). An arc counts only if the robot can stop on it, margin included,
/// before its room ends; standing and turning always counts. `limit_m_s`: no faster.
ChosenArc choose_arc(const ArcConfig& config, const RoomToDrive& room, const Pose2& chart_from_robot,
                     const Twist& moving, const Eigen::Vector2d& carrot, double limit_m_s);

}  // namespace weft::agents
