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

/// Returns the speed to have at `along_m`, m/s: at most `limit_m_s`, slow enough for the bends ahead, to reach the
/// end at rest, and to work off lateral and heading errors before going on fast. 0 at and beyond the end.
double speed_at(const SpeedConfig& config, const Spline& path, double along_m, const TrackError& error,
                double limit_m_s);

/// Controls speed by proportional and integral terms (Gadd & Newman III-D), to make up for a base that does not do
/// what it is told. Limits the acceleration of the command, starting from the speed that the base has when control
/// begins; does not limit braking. Is a value: the state between samples.
class SpeedControl {
 public:
  /// Returns the command for the wanted and the measured speed; all m/s, elapsed in s. Never negative for wanted >=
  /// 0.
  double update(const SpeedConfig& config, double wanted_m_s, double measured_m_s, double elapsed_s);
  void reset() { *this = SpeedControl{}; }

 private:
  double integral_m_s_ = 0.0;
  std::optional<double> set_m_s_;  // the wanted speed after the acceleration limit; none: control begins
};

}  // namespace weft::agents
