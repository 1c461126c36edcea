#pragma once
#include <optional>

#include "agents/control/spline.hpp"
#include "agents/control/steering.hpp"

namespace weft::agents {

struct SpeedConfig {
  double acceleration_m_s2 = 0.4;          ///< of the command; (0, 3]
  double deceleration_m_s2 = 0.4;          ///< planned towards the end and bends; (0, 3]
  double lateral_acceleration_m_s2 = 0.3;  ///< v^2 |curvature| stays below it; (0, 3]
  double slowest_m_s = 0.05;               ///< when creeping to the end or far off the path; (0, 0.3]
  double cross_track_halves_m = 0.1;       ///< lateral error that halves the speed; (0, 2]
  double proportional = 0.3;               ///< on the speed error; [0, 2]
  double integral_1_s = 0.5;               ///< [0, 5]
  double integral_limit_m_s = 0.1;         ///< most that the integral adds; [0, 0.5]
};

/// The speed to have at `along_m`: below `limit`, such that bends ahead are met slowly enough, the end is reached at
/// rest, and lateral and heading errors are worked off before going on fast. 0 at and beyond the end.
double speed_at(const SpeedConfig& config, const Spline& path, double along_m, const TrackError& error,
                double limit_m_s);

/// Proportional-integral speed control (Gadd & Newman III-D): makes up for a base that does not do what it is told.
/// Acceleration of the command is limited, from what the base does when control begins; braking is not held up. A
/// value: the state between samples.
class SpeedControl {
 public:
  /// The command for the wanted and the measured speed; all m/s, elapsed in seconds. Never negative for wanted >= 0.
  double update(const SpeedConfig& config, double wanted_m_s, double measured_m_s, double elapsed_s);
  void reset() { *this = SpeedControl{}; }

 private:
  double integral_m_s_ = 0.0;
  std::optional<double> set_m_s_;  // the wanted speed after the acceleration limit; none: control begins
};

}  // namespace weft::agents
