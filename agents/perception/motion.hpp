#pragma once
#include <optional>

#include "core/time.hpp"

namespace weft::agents {

/// Describes a velocity command to a base, in the robot frame (REP 103).
struct Twist {
  double linear_m_s = 0.0;
  double angular_rad_s = 0.0;
  bool operator==(const Twist&) const = default;
};

/// Holds the increment of the wheels since the last sample, as the base reports it: useful, but not exact.
struct WheelStep {
  double distance_m = 0.0;
  double heading_rad = 0.0;
};

/// Tells what caused a body's motion since the last sample: the command, and the wheels' step.
struct Motion {
  Duration elapsed{};
  Twist command;                    ///< in force meanwhile
  std::optional<WheelStep> wheels;  ///< where the body has them
};

}  // namespace weft::agents
