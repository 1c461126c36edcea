#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "core/network/relation.hpp"
#include "core/time.hpp"

namespace weft {

/// Tells where a goal is in its life (docs/path-of-a-goal.md): pending -> assigned -> executing (<-> paused) ->
/// succeeded | failed | cancelled; or rejected at once.
enum class GoalState : std::uint8_t {
  pending = 1,
  assigned = 2,
  executing = 3,
  paused = 4,
  succeeded = 5,
  failed = 6,
  cancelled = 7,
  rejected = 8
};
const char* to_string(GoalState state);
bool is_terminal(GoalState state);

enum class GoalKind : std::uint8_t {
  operator_asked = 1,
  yield = 2,   ///< traffic asks a robot to make way; ends by itself
  charge = 3,  ///< the server sends it to a charger
  park = 4     ///< the server sends it out of others' way, to a parking place
};
const char* to_string(GoalKind kind);

/// Records one step of a goal's life, kept for "why".
struct GoalEvent {
  WallTime at{};
  GoalState state = GoalState::pending;
  std::string cause;
  std::string who;  ///< the client's or robot's name
};

/// Holds a request of an operator, or of the server, that a robot go to a place, and its life. Accepted means stored.
struct Goal {
  GoalId id;
  std::string label;              ///< the station asked for
  PlaceId to;                     ///< what the label meant when the goal was accepted
  std::optional<RobotId> wanted;  ///< none: any robot
  std::optional<RobotId> robot;   ///< who has it
  GoalState state = GoalState::pending;
  std::uint64_t number = 0;      ///< order of acceptance; ties and listings
  std::optional<RouteId> route;  ///< the latest one
  std::uint32_t route_version = 0;
  std::uint8_t priority = 0;  ///< class, up to kHighestPriority (core/network/rule.hpp), which is the most urgent
  GoalKind kind = GoalKind::operator_asked;
  bool no_return = false;  ///< the operator accepts that no way may lead on from there
  std::vector<GoalEvent> history;
};

/// Bounds how fast a piece of a route may be driven.
struct SpeedLimit {
  std::uint32_t from = 0;  ///< index of the place from which on it holds
  std::uint32_t to = 0;    ///< index of the last place of the piece, not before `from`
  double limit_m_s = 0.0;  ///< over 0, at most kFastestLimit_m_s (core/network/rule.hpp)
  bool operator==(const SpeedLimit&) const = default;
};
inline constexpr std::size_t kRouteLimits = 1000;  ///< most speed limits of one route

/// Lists places in order with their relations, released up to an index that the robot never passes.
struct Route {
  GoalId goal;
  RouteId id;
  std::uint32_t version = 1;  ///< counts up when the map under it changes or it is planned anew
  Revision made_of;
  RobotId robot;
  std::vector<PlaceId> places;
  std::vector<Relation> relations;  ///< places[i]_from_places[i + 1]; one fewer than places
  std::uint32_t released = 0;       ///< index of the last place that may be reached
  std::vector<SpeedLimit> limits;   ///< by their first index; where several hold, the lowest does
  bool ended = false;               ///< no more of it: stop at the released point and forget it
  std::string reason;               ///< why it ended or waits, for people
};

}  // namespace weft
