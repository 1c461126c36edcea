#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/network/goal.hpp"
#include "core/time.hpp"
#include "server/traffic/plan/planner.hpp"
#include "server/traffic/traffic.hpp"

namespace weft::server {

/// Returns how long after a plan of so many robots the next one may come. A plan takes the longer the more there are,
/// and with more of them something changes more often: else 200 robots keep two cores busy.
Duration least_between_plans(std::size_t robots);

/// Keeps the plan of everybody's moves, and says when there is to be another one. A plan is made in pieces, between
/// which messages are heard; until it is made there is none, so that nobody is released by the one before. It always
/// comes to an end: what changes meanwhile is left to the next one.
class Planning {
 public:
  explicit Planning(Proximity& proximity) : planner_(proximity, PlanRules{}) {}

  /// Returns whether the next piece of a plan is to be made, or the plan is older than a second, or somebody asked
  /// for another one.
  bool is_due(SteadyTime now) const { return now >= next(); }
  SteadyTime next() const { return is_under_way_ ? piece_at_ : next_; }
  bool is_under_way() const { return is_under_way_; }
  /// Asks for another plan: there is a goal more or less. At once, unless there are many robots.
  void want() { next_ = std::min(next_, at_once_); }
  /// Asks for another plan soon: a robot is not where the plan has it.
  void want_soon() { next_ = std::min(next_, soonest_); }
  /// Notes that something was taken out of the map, came back, or is ruled otherwise: the next plan has to know.
  void map_edited() { followed_at_.reset(); }
  /// Has what lies around robots looked up in that map from now on, though the plan may follow an earlier one.
  void see(std::shared_ptr<const Snapshot> latest) { planner_.see(std::move(latest)); }
  /// Begins a plan in place of the one that there is.
  void begin(const RuledNetwork& network, double footprint_m, std::vector<PlanRequest> requests, SteadyTime now);
  /// Makes the next piece of it. Returns whether it is made.
  bool work(SteadyTime now);

  /// Describes a robot as the plan has it: where it ends, and where it was going.
  struct Asked {
    RobotId robot;
    PlaceId end;
    std::optional<PlaceId> goal;
  };
  const std::vector<Asked>& asked() const { return asked_; }
  /// Leaves the robot out until the next plan: it is not going where the plan leads it.
  void leave_out(const RobotId& robot);

  /// Returns the robot's number in the plan, if it stands, or will, where the plan has it; none: it is to be planned.
  std::optional<std::uint32_t> number(const RobotId& robot, const PlaceId& end) const;
  bool has(const RobotId& robot) const { return robots_.contains(robot); }
  /// Returns whether the plan has the robot move.
  bool moves(const RobotId& robot) const {
    const auto found = robots_.find(robot);
    return found != robots_.end() && !planner_.order().moves(found->second.number).empty();
  }

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
    return by == kNobody ? std::nullopt : std::optional(asked_[by].robot);
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
  std::vector<Asked> asked_;  ///< by number
  bool is_under_way_ = false;
  SteadyTime begun_at_;
  SteadyTime piece_at_;
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
