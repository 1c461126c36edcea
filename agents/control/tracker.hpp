#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/control/speed.hpp"
#include "agents/control/spline.hpp"
#include "agents/control/steering.hpp"
#include "agents/perception/motion.hpp"

namespace weft::agents {

struct TrackerConfig {
  SteeringConfig steering;
  SpeedConfig speed;
  double lag_s = 0.1;               ///< the base answers a command about this late: errors are taken there; [0, 0.5]
  double stop_at_m = 0.004;         ///< closer to the end than this it stands; (0, 0.05]
  double turn_first_rad = 0.9;      ///< a heading error above this is turned away standing; (0, 1.5]
  double turn_slowest_rad_s = 0.1;  ///< (0, 0.5]
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const TrackerConfig& config);

/// Holds the result of tracking one sample.
struct Tracked {
  Twist command;
  TrackError error;       ///< now
  double to_end_m = 0.0;  ///< along the path; negative: beyond
  bool at_end = false;    ///< stands within stop_at_m of the end, or beyond it
};

/// Follows a path: Hoffmann steering, PI speed, and a stop at its end. A value: the state between samples; the path
/// is given anew with every sample, in the robot's own frame.
class Tracker {
 public:
  /// Describes the motion of the robot since the last sample, as far as it is known.
  struct Moving {
    double speed_m_s = 0.0;   ///< as measured
    bool knows_aside = true;  ///< false: the path is laid out as if the robot were on it, turned as it is seen to be
    Duration elapsed{};
  };
  /// Returns the command and errors for one sample. `robot_from_path`: the path, a spline in the robot's frame.
  Tracked track(const TrackerConfig& config, const Spline& robot_from_path, double limit_m_s, const Moving& moving);
  /// Turns on the spot by `heading_rad`, gently; zero below `within_rad`.
  Twist turn(const TrackerConfig& config, double heading_rad, double within_rad);
  void reset() { *this = Tracker{}; }

 private:
  SpeedControl speed_;
  double last_angular_rad_s_ = 0.0;
  double turning_rad_s_ = 0.0;  // that the heading error's integral adds
};

}  // namespace weft::agents
