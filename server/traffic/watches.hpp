#pragma once
#include <map>
#include <set>
#include <vector>

#include "server/traffic/stretch.hpp"

namespace weft::server {

/// Remembers what each waiting release waits for: it is looked at again when that is freed, and not before. A robot
/// that is woken waits for nothing here until it has been looked at again.
class Watches {
 public:
  struct Watch {
    RobotId waiter;
    Touched needs;
  };

  /// Waits until none of the holders holds `needs` any more; in place of what the robot waited for before.
  void watch(const RobotId& waiter, const Touched& needs, const std::set<RobotId>& holders);
  /// Waits until anybody gives anything up.
  void watch_everybody(const RobotId& waiter);
  /// Waits until the map has changed, which wakes the others, too.
  void watch_map(const RobotId& waiter);
  void forget(const RobotId& waiter);

  /// Returns the watches that the holder may end: the caller knows whether it still holds what they need.
  std::vector<Watch> on(const RobotId& holder) const;
  void wake(const RobotId& waiter);
  void wake_those_for_everybody();
  void wake_all();
  /// Returns the robots that were woken since the last call.
  std::set<RobotId> take_woken();
  bool has_woken() const { return !woken_.empty(); }

 private:
  struct Waits {
    Touched needs;
    std::set<RobotId> holders;
  };
  std::map<RobotId, Waits> waits_;                ///< by waiting robot
  std::map<RobotId, std::set<RobotId>> waiters_;  ///< by holding robot
  std::set<RobotId> for_everybody_;
  std::set<RobotId> woken_;
};

}  // namespace weft::server
