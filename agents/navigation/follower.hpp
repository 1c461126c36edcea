#pragma once
#include <optional>
#include <set>

#include "agents/navigation/arrival.hpp"
#include "agents/navigation/manner.hpp"
#include "agents/navigation/navigator.hpp"
#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {

/// Follows a route as far as it is released (Gadd & Newman III-D): the places ahead are laid out from where the robot
/// is believed to be, a spline joins them, the robot is steered along it and stops at the released place. A value,
/// pure.
class Follower {
 public:
  explicit Follower(const NavigationConfig& config, const Manner& manner = {}) : config_(config), manner_(manner) {}

  /// Takes a new route, or a new version: goes on from where the robot is, which is not before place `from`.
  void follow(const Route& route, std::uint32_t from = 0);
  void stop();
  const std::optional<Route>& route() const { return route_; }
  /// Returns the places of the route near the robot, which localising prefers.
  const std::set<PlaceId>& near_places() const { return near_; }
  /// Returns whether the robot stands where a fix is waited for.
  bool waits_for_fix() const { return arrival_.waits_for_fix(); }

  struct Seen {
    const Window& window;
    const std::optional<Estimate>& estimate;
    bool lost = false;
    double speed_m_s = 0.0;  ///< measured
    Duration elapsed{};
  };
  /// Holds the decision for one sample: a path to steer along, for a method that steers itself or for the default, or
  /// a command without one.
  struct Drive {
    std::optional<Ahead> along;  ///< set: steer along this
    std::optional<Spline> path;  ///< through `along`; none: the method finds its way
    Navigated navigated;         ///< the command where there is nothing to steer along, progress, state and reason
  };
  Drive look(const Seen& seen);
  /// Steers by the default: spline, Hoffmann, PI.
  Steering steer(const Ahead& ahead, const Spline& path);
  /// Takes what steering along the path has led to: a command, or a stop, which is given up like any other.
  void steered(const Steering& steering, Duration elapsed, Navigated& navigated);

 private:
  void progress(const RouteAround& around);
  void standing(Navigated& navigated, Following following, std::string_view reason);
  /// Stops a robot that knows where it is and cannot go on from there; after `give_up_s` it gives the route up.
  Drive stuck(Drive drive, const Seen& seen, std::string_view reason);
  void stuck(Navigated& navigated, Duration elapsed, std::string_view reason);
  /// Decides how a robot that knows where it is on its route goes on.
  Drive go_on(Drive drive, const RouteAround& around, const Seen& seen);
  Drive by_path(Drive drive, const PathAhead& ahead, const RouteAround& around, const Seen& seen);
  Drive by_places(Drive drive, const PathAhead& ahead, const RouteAround& around, const Seen& seen);
  /// Begins to turn a robot that stands at the beginning of its way and faces elsewhere; false: it does not.
  bool turns_first(const RouteAround& around, bool stands);
  Drive turn_on_the_spot(const RouteAround& around);
  /// Stands at the end of the path: turns on the spot, or the end is reached.
  Drive at_end_of_path(const PathAhead& ahead, const RouteAround& around, const Seen& seen);
  Drive end_of_path(const RouteAround& around, const Estimate& estimate);
  void fill(Navigated& navigated) const;

  /// Describes a turn on the spot, to the heading of a place or, where it is reached, of the way on from it.
  struct Turn {
    std::uint32_t place = 0;
    bool reaches = false;
  };

  NavigationConfig config_;
  Manner manner_;
  std::optional<Route> route_;
  std::set<PlaceId> near_;
  std::optional<std::uint32_t> at_;
  std::uint32_t freed_ = 0;
  bool arrived_ = false;
  bool at_end_ = false;  // the robot has stopped at the end of the released path
  Duration stuck_{};
  Duration stood_{};          // before this sample, as `stuck_` was
  bool faces_anew_ = true;    // which way it faces has not been looked at since it could not drive on
  std::optional<Turn> turn_;  // under way
  Tracker tracker_;
  Arrival arrival_;
};

}  // namespace weft::agents
