#pragma once

#include "agents/methods/method.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Bounds how the robot is steered through what is known to be free.
struct TopometricSteerConfig {
  double around_m = 10.0;       ///< side of the square around the robot that plans look at; [3, 40]
  double turn_first_rad = 0.8;  ///< a way that begins farther off the heading is turned to standing; (0, 3]
  double turned_rad = 0.15;     ///< such a turn ends this near; (0, turn_first_rad]
  double precise_m = 0.02;      ///< at the end of the way it stands this near; (0, 0.1]
  double precise_from_m = 0.4;  ///< from so far before the end it is driven to straight; (0, 2]
  double gain_1_s = 0.8;        ///< speed for each metre left to the end; (0, 5]
  double slowest_m_s = 0.04;    ///< and no slower; (0, 0.5]
  double most_unseen_m = 1.5;   ///< driven since a view was seen: it stands, "blind"; (0, 20]
};

/// Keeps between samples what was steered last.
struct SteerMemory {
  Steering steering = Twist{};
  SensorTime at{};          ///< when that was planned
  bool is_planned = false;  ///< there was any
  bool is_turning = false;  ///< on the spot, towards the way
  double turned_rad = 0.0;  ///< on the spot, since the way was lost
};

}  // namespace weft::agents
