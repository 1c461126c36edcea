#pragma once
#include <cstdint>
#include <string>

#include "core/ids.hpp"
#include "server/base/signers.hpp"

namespace weft::server {

/// States the rule for robots in parts of the map that nothing joins: they do not see one another.
enum class Unjoined : std::uint8_t {
  warn,       ///< an event and `weft doctor` say so
  one_drives  ///< and no more than one robot is on its way at a time
};

/// States the rule for goals of robots that are not heard any more, and that were asked for no robot in particular.
enum class SilentGoal : std::uint8_t {
  keep,       ///< they wait until the robot is heard
  hand_over,  ///< another robot gets them
  ask         ///< an operator is told that one could
};

/// States at which charge, as a share of full, a robot is treated otherwise.
struct ChargeLevels {
  double critical = 0.10;   ///< to a charger before the next goal
  double low = 0.25;        ///< to a charger when there is no goal
  double enough = 0.60;     ///< a robot that charges takes goals again
  double full = 0.95;       ///< makes way at a charger
  double range_m = 5000.0;  ///< that a full battery drives; [1, 1e6]
};
inline constexpr double kChargeReserve = 0.05;  ///< that a robot comes to a charger with, after a goal

/// Holds the settings of one server, checked by `start`.
struct ServiceConfig {
  PeerId self;
  std::uint64_t incarnation = 0;
  std::string name = "server";
  std::string software;
  std::string vendor;                 ///< for the hello
  double robot_silent_after_s = 5.0;  ///< (0, 3600]; shown and alarmed, frees nothing
  Unjoined unjoined = Unjoined::warn;
  /// Sets for how long, [0, 3600] s, a robot is at work at a goal it has come to, and is not asked to make way.
  double handling_s = 10.0;
  SilentGoal silent_goal = SilentGoal::hand_over;
  double silent_goal_after_s = 60.0;  ///< [1, 86400]; for so long a robot is not heard before that rule holds
  ChargeLevels charge{};
  Signers signers{};  ///< of contents that can be recognised; none: robots look for themselves alone
};

}  // namespace weft::server
