#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/network/rule_map.hpp"
#include "server/base/now.hpp"

namespace weft::server {

/// Says for whom a stretch of the floor is closed.
enum class ClosedFor {
  goal,       ///< the goal of an operator on whose way it was found
  own_goals,  ///< what the server asks of the robot that found it: to make way, to park, to charge
};

/// Tells that a stretch of the floor is closed, as a robot found it blocked.
struct Closure {
  PlaceId from;  ///< where the stretch begins on the route of the robot that found it
  PlaceId to;    ///< and where it ends
  ClosedFor whom = ClosedFor::goal;
  ClosedHops hops;  ///< of every run that covers it, in both directions
  std::string found_by;
  WallTime since{};
  SteadyTime until{};
  WallTime until_wall{};  ///< for people
};

/// Lays over the map what is closed for single goals and single robots, each for a while. The map does not change,
/// and nothing is stored: a server that is started again has the robot try once more.
class Overlay {
 public:
  /// Closes what a robot has in front of it that has passed that place of the route last: for what the server asks of
  /// that robot by itself, and for the route's goal where an operator asked for that. Returns what is closed; null:
  /// the route is a single place.
  const Closure* close(const Snapshot& network, const Route& route, std::uint32_t at, const std::string& found_by,
                       ClosedFor whom, Now now);

  /// Returns what is closed for the goal, all together; null: nothing is.
  const ClosedHops* closed(const GoalId& goal) const;
  /// Returns what is closed for what the server asks of the robot, all together; null: nothing is.
  const ClosedHops* closed(const RobotId& robot) const;
  /// Returns the goal's closures, in the order in which they were made.
  const std::vector<Closure>& of(const GoalId& goal) const;
  bool empty() const { return goals_.empty() && robots_.empty(); }

  struct Opened {
    GoalId goal;
    Closure closure;
  };
  /// Ends the closures whose time is over, and returns those for goals.
  std::vector<Opened> take_over(SteadyTime now);
  /// Ends the closures of which a robot, which has come from one place of its route to another, has now left the
  /// floor at the other end, and returns those for goals.
  std::vector<Opened> take_driven(const Route& route, std::uint32_t from, std::uint32_t to);
  /// Forgets what is closed for the goal; what its robot found stays closed for what the server asks of that.
  void forget(const GoalId& goal) { goals_.erase(goal); }
  /// Returns when the next closure ends by itself; none: there is none.
  std::optional<SteadyTime> next() const;

 private:
  /// Holds what is closed for one goal, or one robot.
  struct Closed {
    std::vector<Closure> closures;
    ClosedHops all;
    const Closure& add(const Closure& closure);
  };
  template <class IsOver>
  std::vector<Opened> take(IsOver&& is_over);

  std::map<GoalId, Closed> goals_;
  std::map<RobotId, Closed> robots_;
};

/// Says what is closed, by whom it was found, since when, and until when, for people.
std::string text_of(const Closure& closure);

}  // namespace weft::server
