#pragma once
#include <optional>

#include "core/time.hpp"

namespace weft::agents {

/// What a base is asked to do, in the robot frame (REP 103).
struct Twist {
  double linear_m_s = 0.0;
  double angular_rad_s = 0.0;
  bool operator==(const Twist&) const = default;
};

/// Increment of the wheels since the last sample, as the base reports it; not true, merely useful.
struct WheelStep {
  double distance_m = 0.0;
  double heading_rad = 0.0;
};

/// What moved the body since the last sample.
struct Motion {
  Duration elapsed{};
  Twist command;                    ///< in force meanwhile
  std::optional<WheelStep> wheels;  ///< where the body has them
};

}  // namespace weft::agents
