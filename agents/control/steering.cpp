#include "agents/control/steering.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

TrackError track_error(const Pose2& frame_from_path, const Pose2& frame_from_robot) {
  const Pose2 path_from_robot = frame_from_path.inverse() * frame_from_robot;
  return {path_from_robot.y, path_from_robot.heading};
}

double steer_rate(const SteeringConfig& config, const TrackError& error, double curvature_1_m, double speed_m_s) {
  const double speed = std::max(speed_m_s, 0.0);
  const double approach =
      std::clamp(std::atan(config.cross_track_gain_1_s * error.cross_track_m / (config.softening_m_s + speed)),
                 -config.max_approach_rad, config.max_approach_rad);
  const double rate = speed * curvature_1_m - config.heading_gain_1_s * wrap_angle(error.heading_rad + approach);
  return std::clamp(rate, -config.max_angular_rad_s, config.max_angular_rad_s);
}

}  // namespace weft::agents
