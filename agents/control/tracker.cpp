#include "agents/control/tracker.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

std::vector<Error> check(const TrackerConfig& config) {
  std::vector<Error> issues;
  const auto within = [&](const char* name, double value, double low, double high, bool low_too) {
    if (value <= high && (value > low || (low_too && value == low))) return;
    issues.push_back({ErrorCode::invalid, std::string("control: ") + name + " is " + std::to_string(value) +
                                              "; it must be in " + (low_too ? "[" : "(") + std::to_string(low) +
                                              ", " + std::to_string(high) + "]"});
  };
  within("steering.cross_track_gain_1_s", config.steering.cross_track_gain_1_s, 0, 5, false);
  within("steering.softening_m_s", config.steering.softening_m_s, 0, 1, false);
  within("steering.heading_gain_1_s", config.steering.heading_gain_1_s, 0, 10, false);
  within("steering.max_approach_rad", config.steering.max_approach_rad, 0, 1.5, false);
  within("steering.max_angular_rad_s", config.steering.max_angular_rad_s, 0, 5, false);
  within("speed.acceleration_m_s2", config.speed.acceleration_m_s2, 0, 3, false);
  within("speed.deceleration_m_s2", config.speed.deceleration_m_s2, 0, 3, false);
  within("speed.lateral_acceleration_m_s2", config.speed.lateral_acceleration_m_s2, 0, 3, false);
  within("speed.slowest_m_s", config.speed.slowest_m_s, 0, 0.3, false);
  within("speed.cross_track_halves_m", config.speed.cross_track_halves_m, 0, 2, false);
  within("speed.proportional", config.speed.proportional, 0, 2, true);
  within("speed.integral_1_s", config.speed.integral_1_s, 0, 5, true);
  within("speed.integral_limit_m_s", config.speed.integral_limit_m_s, 0, 0.5, true);
  within("lag_s", config.lag_s, 0, 0.5, true);
  within("stop_at_m", config.stop_at_m, 0, 0.05, false);
  within("turn_first_rad", config.turn_first_rad, 0, 1.5, false);
  within("turn_slowest_rad_s", config.turn_slowest_rad_s, 0, 0.5, false);
  return issues;
}

Twist Tracker::turn(const TrackerConfig& config, double heading_rad, double within_rad) {
  speed_.reset();
  // What the base has not yet answered of the last command will still turn it.
  const double left = wrap_angle(heading_rad - last_angular_rad_s_ * config.lag_s);
  if (std::abs(left) <= within_rad) {
    last_angular_rad_s_ = 0.0;
    return {};
  }
  const double rate = std::clamp(std::abs(left) * config.steering.heading_gain_1_s * 0.5, config.turn_slowest_rad_s,
                                 0.6 * config.steering.max_angular_rad_s);
  last_angular_rad_s_ = std::copysign(std::max(rate, config.turn_slowest_rad_s), left);
  return {0.0, last_angular_rad_s_};
}

Tracked Tracker::track(const TrackerConfig& config, const Spline& robot_from_path, double limit_m_s, double speed_m_s,
                       Duration elapsed) {
  // Not the whole path: a bend may bring a later part of it nearer than the one that is being driven.
  constexpr double reach_m = 2.0;
  const double length = robot_from_path.length_m();
  const double everywhere = length < reach_m ? length + 1.0 : reach_m;
  const double now_at = robot_from_path.nearest({0.0, 0.0}, -1.0, everywhere);
  Tracked tracked;
  tracked.error = track_error(robot_from_path.at(now_at).pose, Pose2{});
  tracked.to_end_m = robot_from_path.length_m() - now_at;

  const Pose2 soon = exp2({speed_m_s * config.lag_s, 0.0, last_angular_rad_s_ * config.lag_s});
  const double soon_at = robot_from_path.nearest(soon.translation(), -1.0, everywhere);
  const PathPoint there = robot_from_path.at(soon_at);
  const TrackError error = track_error(there.pose, soon);
  if (robot_from_path.length_m() - soon_at <= config.stop_at_m) {
    tracked.at_end = true;
    reset();
    return tracked;
  }
  if (std::abs(error.heading_rad) > config.turn_first_rad && std::abs(speed_m_s) < 0.1) {
    tracked.command = turn(config, -error.heading_rad, 0.0);
    return tracked;
  }
  const double wanted = speed_at(config.speed, robot_from_path, soon_at, error, limit_m_s);
  const double linear = std::min(speed_.update(config.speed, wanted, speed_m_s, seconds(elapsed)), limit_m_s * 1.2);
  // The bend over a stretch: at a point it would repeat every error of a pose's heading.
  constexpr double half_m = 0.1;
  const double bend_rad = wrap_angle(robot_from_path.at(soon_at + half_m).pose.heading -
                                     robot_from_path.at(soon_at - half_m).pose.heading);
  const double angular = steer_rate(config.steering, error, bend_rad / (2.0 * half_m), std::max(speed_m_s, 0.0));
  last_angular_rad_s_ = angular;
  tracked.command = {linear, angular};
  return tracked;
}

}  // namespace weft::agents
