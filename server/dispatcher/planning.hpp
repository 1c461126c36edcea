#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/network/goal.hpp"
#include "core/time.hpp"
#include "server/traffic/plan/planner.hpp"
#include "server/traffic/traffic.hpp"

namespace weft::server {

/// Returns how long after a plan of so many robots the next one may come. A plan takes the longer the more there are,
/// and with more of them something changes more often: else 200 robots keep two cores busy.
Duration least_between_plans(std::size_t robots);

/// Keeps the plan of everybody's moves, and says when there is to be another one.
class Planning {
 public:
  explicit Planning(Proximity& proximity) : planner_(proximity, PlanRules{}) {}

  /// Returns whether the plan is older than a second, or somebody asked for another one.
  bool is_due(SteadyTime now) const { return now >= next_; }
  SteadyTime next() const { return next_; }
  /// Asks for another plan: there is a goal more or less. At once, unless there are many robots.
  void want() { next_ = std::min(next_, at_once_); }
  /// Asks for another plan soon: a robot is not where the plan has it.
  void want_soon() { next_ = std::min(next_, soonest_); }
  /// Notes that something was taken out of the map, came back, or is ruled otherwise: the next plan has to know.
  void map_edited() { followed_at_.reset(); }
  void plan(const RuledNetwork& network, double footprint_m, const std::vector<PlanRequest>& requests,
            SteadyTime now);

  /// Returns the robot's number in the plan, if it stands, or will, where the plan has it; none: it is to be planned.
  std::optional<std::uint32_t> number(const RobotId& robot, const PlaceId& end) const;
  bool has(const RobotId& robot) const { return robots_.contains(robot); }

  /// Describes what the robot may be released next.
  struct Piece {
    std::vector<PlaceId> places;       ///< beyond what it was released
    std::vector<std::uint32_t> stops;  ///< of these, by index
    bool has_more = false;             ///< moves are planned that others come before
  };
  Piece piece(std::uint32_t number, const std::vector<PlaceId>& held);
  /// Notes that the robot is released to so many stops of its latest piece, and ends there; 0: elsewhere than
  /// planned.
  void released(const RobotId& robot, std::size_t stops, const PlaceId& end);
  /// Returns whom the robot waits for that is not released what comes next, though nobody holds it.
  std::set<RobotId> waits_for(std::uint32_t number);
  /// Returns who cuts the robot off from its goal until a person helps that one; none: nobody does.
  std::optional<RobotId> cut_off_by(std::uint32_t number) const {
    const std::uint32_t by = planner_.cut_off_by(number);
    return by == kNobody ? std::nullopt : std::optional(of_[by]);
  }
  /// Returns whether the robot may drive on along that way though the plan does not say so.
  bool is_safe(std::uint32_t number, const std::vector<PlaceId>& ahead) { return planner_.is_safe(number, ahead); }

 private:
  struct Planned {
    std::uint32_t number = 0;
    PlaceId end;
  };

  Planner planner_;
  std::map<RobotId, Planned> robots_;
  std::vector<RobotId> of_;  ///< by number
  SteadyTime next_;
  SteadyTime soonest_;
  SteadyTime at_once_;                     ///< of many robots: as soon as any
  std::optional<SteadyTime> followed_at_;  ///< when a plan was made of the map as it was then
};

/// Returns the route that goes on with these places from its released end, or from its beginning when nothing is
/// `told` of it, and from there by `tail`; none: the network does not lead so.
std::optional<Route> led_by(const Snapshot& network, const Route& route, bool told,
                            const std::vector<PlaceId>& places, const std::vector<PlaceId>& tail);

}  // namespace weft::server
