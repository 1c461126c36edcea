#pragma once
#include <optional>
#include <string>

#include "agents/agent/map_window.hpp"
#include "agents/agent/missions/stray_policy.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/agent/route_task.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Drives the route that the server has given. A new route waits until the robot knows where it is and the map of its
/// beginning is there.
class FollowMission {
 public:
  struct Uses {
    Navigator& navigator;
    const MapWindow& map;
    Outbox& outbox;
  };
  explicit FollowMission(const Uses& uses) : uses_(uses) {}

  enum class Took {
    nothing,  ///< the places of the route are the same
    route,    ///< another route or version
    end       ///< no route any more: stand
  };
  Took take(const Route& order, bool is_stopped, SteadyTime now);
  /// Takes what a sample has led to.
  void step(const Navigated& navigated, bool is_stopped, SteadyTime now);
  /// Goes on at a tick. `may_drive`: nobody has stopped the robot, its body is well, and it is not being taught.
  void tick(bool may_drive, SteadyTime now);

  /// Stops the robot; `reason` is reported.
  void stop(const std::string& reason, SteadyTime now);
  /// Lets the robot drive on after a stop.
  void resume(SteadyTime now) { at_latest_ = now; }
  void fail(const std::string& reason, SteadyTime now);
  /// Lets the route wait for the end of a search for where the robot is, which begins now.
  void await_localisation(SteadyTime now);
  /// Gives a route back that lies elsewhere than the robot. Returns whether it did.
  bool give_back_if_astray();

  const RouteTask& task() const { return task_; }
  const std::optional<Route>& route() const { return task_.route(); }
  bool has_route() const { return task_.route().has_value(); }
  /// Returns whether there is a route whose end is not reached.
  bool is_under_way() const { return has_route() && !task_.arrived(); }
  bool strays() const { return stray_.strays(); }
  /// Says why a route is not followed yet, for people; empty: it is.
  const std::string& waits_for() const { return waits_for_; }

  std::optional<msg::RouteProgress> due(SteadyTime now) { return task_.due(now); }
  std::optional<SteadyTime> next(bool may_drive) const;
  void was_away(Duration away) { at_latest_ += away; }
  void server_restarted(SteadyTime now) { task_.server_restarted(now); }

 private:
  void renew(bool same_route, bool is_stopped, SteadyTime now);
  void report(const Navigated& navigated, SteadyTime now);
  void arrive(SteadyTime now);

  Uses uses_;
  RouteTask task_;
  StrayPolicy stray_;
  bool is_pending_ = false;  ///< the route waits for the map or for a localisation
  SteadyTime at_latest_{};   ///< then it is followed with the map that is there
  std::string waits_for_;
};

}  // namespace weft::agents
