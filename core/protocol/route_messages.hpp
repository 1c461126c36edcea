#pragma once
#include <cstdint>
#include <string>

#include "core/network/goal.hpp"
#include "core/protocol/peers.hpp"

/// Holds how routes are ordered and reported on.
namespace weft::msg {

struct RouteOrder {
  Header header;
  RobotId to;
  Route route;
};

enum class RoutePhase : std::uint8_t { accepted = 1, driving = 2, waiting = 3, arrived = 4, stopped = 5, failed = 6 };
const char* to_string(RoutePhase phase);

struct RouteProgress {
  Header header;
  GoalId goal;
  RouteId route;
  std::uint32_t version = 0;
  RoutePhase phase = RoutePhase::accepted;
  std::uint32_t at = 0;        ///< index of the last place passed
  std::uint32_t freed = 0;     ///< everything before this index is no longer touched
  std::uint32_t released = 0;  ///< as the robot knows it
  Relation goal_from_robot;    ///< when arrived: as believed
  std::string reason;
};

}  // namespace weft::msg
