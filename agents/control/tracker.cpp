#include "agents/control/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/control/settings.hpp"

namespace weft::agents {

std::vector<Error> check(const TrackerConfig& config) {
  OutOfBounds out("control");
  each_control_setting(config, [&](const char* part) { return out.section(part); });
  return std::move(out.issues);
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

Tracked Tracker::track(const TrackerConfig& config, const Spline& robot_from_path, double limit_m_s,
                       const Moving& moving) {
  const double speed_m_s = moving.speed_m_s;
  // Not the whole path: a bend may bring a later part of it nearer than the one that is being driven.
  constexpr double reach_m = 2.0;
  const double length = robot_from_path.length_m();
  const double everywhere = length < reach_m ? length + 1.0 : reach_m;
  const double now_at = robot_from_path.nearest({0.0, 0.0}, -1.0, everywhere);
  Tracked tracked;
  tracked.error = track_error(robot_from_path.at(now_at).pose, Pose2{});
  tracked.to_end_m = robot_from_path.length_m() - now_at;

  const Pose2 soon = se2_exp({speed_m_s * config.lag_s, 0.0, last_angular_rad_s_ * config.lag_s});
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
  const double linear =
      std::min(speed_.update(config.speed, wanted, speed_m_s, seconds(moving.elapsed)), limit_m_s * 1.2);
  // The bend over a stretch: at a point it would repeat every error of a pose's heading.
  constexpr double half_m = 0.1;
  const double bend_rad = wrap_angle(robot_from_path.at(soon_at + half_m).pose.heading -
                                     robot_from_path.at(soon_at - half_m).pose.heading);
  if (!moving.knows_aside) {
    constexpr double most_rad_s = 0.15;
    const double more = -config.steering.heading_integral_1_s2 * tracked.error.heading_rad * seconds(moving.elapsed);
    turning_rad_s_ = std::clamp(turning_rad_s_ + more, -most_rad_s, most_rad_s);
  }
  const double angular = std::clamp(
      steer_rate(config.steering, error, bend_rad / (2.0 * half_m), std::max(speed_m_s, 0.0)) + turning_rad_s_,
      -config.steering.max_angular_rad_s, config.steering.max_angular_rad_s);
  last_angular_rad_s_ = angular;
  tracked.command = {linear, angular};
  return tracked;
}

}  // namespace weft::agents
