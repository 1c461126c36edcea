#pragma once
#include "agents/control/tracker.hpp"
#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {

/// Calls `in(name, value, Low, low, high)` for every setting of the controller, for whoever checks or reads them;
/// `section(name)` returns the `in` of a part ("": the tracker's own settings).
template <class Config, class Section>
void each_control_setting(Config& config, Section&& section) {
  const auto tracker = section("");
  tracker("lag_s", config.lag_s, Low::closed, 0, 0.5);
  tracker("stop_at_m", config.stop_at_m, Low::open, 0, 0.05);
  tracker("turn_first_rad", config.turn_first_rad, Low::open, 0, 1.5);
  tracker("turn_slowest_rad_s", config.turn_slowest_rad_s, Low::open, 0, 0.5);
  const auto steering = section("steering");
  steering("cross_track_gain_1_s", config.steering.cross_track_gain_1_s, Low::open, 0, 5);
  steering("softening_m_s", config.steering.softening_m_s, Low::open, 0, 1);
  steering("heading_integral_1_s2", config.steering.heading_integral_1_s2, Low::closed, 0, 5);
  steering("heading_gain_1_s", config.steering.heading_gain_1_s, Low::open, 0, 10);
  steering("max_approach_rad", config.steering.max_approach_rad, Low::open, 0, 1.5);
  steering("max_angular_rad_s", config.steering.max_angular_rad_s, Low::open, 0, 5);
  const auto speed = section("speed");
  speed("acceleration_m_s2", config.speed.acceleration_m_s2, Low::open, 0, 3);
  speed("deceleration_m_s2", config.speed.deceleration_m_s2, Low::open, 0, 3);
  speed("lateral_acceleration_m_s2", config.speed.lateral_acceleration_m_s2, Low::open, 0, 3);
  speed("slowest_m_s", config.speed.slowest_m_s, Low::open, 0, 0.3);
  speed("cross_track_halves_m", config.speed.cross_track_halves_m, Low::open, 0, 2);
  speed("proportional", config.speed.proportional, Low::closed, 0, 2);
  speed("integral_1_s", config.speed.integral_1_s, Low::closed, 0, 5);
  speed("integral_limit_m_s", config.speed.integral_limit_m_s, Low::closed, 0, 0.5);
}

}  // namespace weft::agents
