#pragma once
#include <map>
#include <set>
#include <string>

#include "server/dispatcher/charge.hpp"

namespace weft::server {

/// Keeps what the server decides goals of its own by: to charge, and to park. Is not stored: reports bring it again.
struct OwnGoals {
  explicit OwnGoals(const ChargeLevels& levels) : charge(levels) {}

  ChargeWatch charge;
  std::set<RobotId> fell_short;                   ///< robots whose charge did not cover the goal looked at last
  std::map<RobotId, SteadyTime> idle_since;       ///< or since it was tried in vain to park it
  std::map<RobotId, std::set<std::string>> said;  ///< kinds of events that were said of a robot, and hold
};

}  // namespace weft::server
