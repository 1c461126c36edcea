#pragma once
#include <map>
#include <optional>
#include <vector>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "server/base/config.hpp"

namespace weft::server {

/// Returns nothing for levels that go together. invalid: names the one that does not, and its bound.
Result<void> check(const ChargeLevels& levels);

/// Returns what share of full a way takes, and the reserve.
double share_for(const ChargeLevels& levels, double way_m);

/// Follows what robots' batteries hold, and decides which robots are to charge, and take no goals meanwhile. Knows
/// only robots that have said what their batteries hold.
class ChargeWatch {
 public:
  explicit ChargeWatch(const ChargeLevels& levels) : levels_(levels) {}

  /// Takes what a robot has said of its battery.
  void take(const RobotId& robot, double share, bool is_charging, SteadyTime now);
  /// Notes that the robot's charge did not cover a goal: it is to charge, as if it was low.
  void fell_short(const RobotId& robot, SteadyTime now);
  /// Notes that the robot goes to a charger: it takes no goal until it has enough.
  void sent(const RobotId& robot);

  /// Returns what its battery holds, in whole percent; none: it has not said.
  std::optional<int> percent(const RobotId& robot) const;
  /// Returns whether it takes no goals: it is critical, or charges and has not enough yet.
  bool is_recharging(const RobotId& robot) const;
  bool is_critical(const RobotId& robot) const;
  /// Returns whether it may give its charger up: it is full, or nobody knows.
  bool is_full(const RobotId& robot) const;
  /// Returns the robots that are to charge, in turn: critical ones first, then those that have been low for longest.
  std::vector<RobotId> queue() const;

 private:
  struct Known {
    double share = 0.0;
    bool is_recharging = false;
    std::optional<SteadyTime> wants_since;  ///< that it is to charge; none: it is not
  };
  const Known* find(const RobotId& robot) const;

  ChargeLevels levels_;
  std::map<RobotId, Known> robots_;
};

}  // namespace weft::server
