#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "agents/navigation/navigator.hpp"
#include "core/network/goal.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Keeps the route that the server gave this robot, and what the robot tells about it. Orders come doubled, late and
/// out of order: a lower version and a route that is over are ignored, what has been released is never taken back.
class RouteTask {
 public:
  enum class Took {
    ignored,   ///< nothing new
    renewed,   ///< another route or version: follow it
    extended,  ///< released further: follow it
    ended,     ///< no route any more: stand
  };
  Took take(const Route& order, SteadyTime now);

  /// Gives the route back: it leads from where the robot is not. What is released of this version from now on is
  /// ignored; the server, which sees that the robot has no route, plans a next one from where it stands.
  void give_back();

  const std::optional<Route>& route() const { return route_; }
  msg::RoutePhase phase() const { return phase_; }
  /// Returns the index of the last place that the robot has passed, as far as that is known.
  std::uint32_t at() const { return at_; }
  bool arrived() const { return phase_ == msg::RoutePhase::arrived; }

  /// Sets the phase: what the robot does with the route now. Having arrived, and having failed, last until another
  /// version or the end.
  void set(msg::RoutePhase phase, const std::string& reason, SteadyTime now);
  /// Sets how far along the route the robot is; never goes back within a version, nor where the
  /// next version begins by the same places.
  void set_progress(std::uint32_t at, std::uint32_t freed, SteadyTime now);
  /// Sets goal_from_robot as believed, on arrival.
  void set_arrival(const Relation& goal_from_robot) { goal_from_robot_ = goal_from_robot; }

  /// Returns a report without its header: on a change at most five times a second, and every other second without.
  std::optional<msg::RouteProgress> due(SteadyTime now);
  std::optional<SteadyTime> next() const;
  void server_restarted(SteadyTime now) { touch(now); }

 private:
  void touch(SteadyTime now);
  void end(const RouteId& id);

  std::optional<Route> route_;
  msg::RoutePhase phase_ = msg::RoutePhase::accepted;
  std::string reason_;
  std::uint32_t at_ = 0;
  std::uint32_t freed_ = 0;
  Relation goal_from_robot_;
  std::deque<RouteId> over_;
  RouteId given_back_;
  std::uint32_t given_back_version_ = 0;
  SteadyTime report_at_{};
  SteadyTime reported_at_{};
};

}  // namespace weft::agents
