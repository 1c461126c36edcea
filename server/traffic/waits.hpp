#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "server/base/now.hpp"

namespace weft::server {

/// Describes a robot that stands with a route and cannot have the next piece of it: it goes on when all that hold
/// that have left.
struct Wait {
  RobotId robot;
  PlaceId at;
  PlaceId needs;  ///< the first place that it cannot have; none: its wait is not for a place
  std::set<RobotId> held_by;
  Now since;
  std::string rule{};  ///< the name of the one that keeps it from there; empty: none does
};

/// Tells why a robot will not move by itself.
enum class Stays : std::uint8_t {
  idle,     ///< it has no goal
  paused,   ///< by an operator, or as two of its id are heard
  lost,     ///< it does not know where it is
  faulted,  ///< its agent says that it cannot work
  silent,   ///< it is not heard
  no_way,   ///< it has a goal and no route there
  stopped,  ///< its base's own safety holds it
  held,     ///< an operator holds it
  ruled,    ///< a rule keeps it from going on
  blocked,  ///< it is asked to drive, and has not moved for long
};

/// Names robots that wait and will not go on: those of a cycle, or one that will not move, and the robots that wait
/// for them.
struct Standstill {
  std::vector<RobotId> core;    ///< each waits for the next one, the last one for the first; or the one that stays
  std::optional<Stays> stays;   ///< why the one stays; none: it is a cycle
  std::vector<RobotId> behind;  ///< robots that wait for them, or for one of these; nearest first
  bool operator==(const Standstill&) const = default;
};

/// Finds all standstills. Names both when a cycle waits for another one, or for a robot that stays. Robots that are
/// in neither list move, and so do, in the end, those that wait for these alone.
std::vector<Standstill> standstills(const std::vector<Wait>& waits, const std::map<RobotId, Stays>& stays);

}  // namespace weft::server
