#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/traffic/holdings.hpp"
#include "server/traffic/proximity.hpp"
#include "server/traffic/stretch.hpp"
#include "server/traffic/watches.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Decides who may touch what. A robot holds a stretch of the network: of its route what is released and not yet
/// freed, else the place where it stands. Two robots never hold overlapping places, except while one of them stands
/// within what the other holds and moves away from it. A stretch is given up by its holder's report or by an
/// operator, never because time has passed. A robot that never knew where it is holds nothing.
class Traffic {
 public:
  Traffic(Context& context, std::map<RobotId, storage::PutOccupancy> stored, Now now);

  /// Tells how far a route can be released for its robot.
  struct Way {
    enum class End : std::uint8_t {
      free,         ///< nothing is in the way
      held,         ///< somebody holds what comes next
      not_laid,     ///< it is not known yet where what comes next lies, or where somebody is
      turn,         ///< nobody holds it, and others are planned to come by first
      one_at_once,  ///< somebody drives, and robots are in parts of the map that nothing joins
    };
    std::optional<std::uint32_t> through;  ///< none: not even its first place is free
    End end = End::free;
    std::set<RobotId> blocked_by;  ///< held, turn, one_at_once: by whom, all of them
    Touched needs;                 ///< held, not_laid, turn: the first place that it cannot have
    bool is_away = false;          ///< it gets out of what somebody else holds
    bool ends_alike(const Way& other) const { return end == other.end && blocked_by == other.blocked_by; }
  };
  using Stops = std::vector<std::uint32_t>;
  /// Tells how far the route can be released from that place on. When it ends early, `take_woken` names the robot
  /// once it is worth while to ask again. `stops`: the indices at which a release may end, in order, and no farther
  /// than the last one; null: anywhere, with room to set off before the robot that is in the way.
  Way way(const Route& route, std::uint32_t from, const Stops* stops = nullptr);
  /// Returns who may be released farther than it was when `way` was asked last.
  std::set<RobotId> take_woken() { return watches_.take_woken(); }
  bool has_woken() const { return watches_.has_woken(); }
  /// Returns the first place of the route, from that one on, that its robot cannot have because of what `by` holds,
  /// there or beside: of `by` alone, or else of others too. None: `by` is not in the way.
  std::optional<Touched> first_held_by(const RobotId& by, const Route& route, std::uint32_t from);
  /// Returns the robots that are in that way now.
  std::set<RobotId> holders_of(const RobotId& robot, const Way& way);

  /// Returns what has to be committed with a release: the new stretch, and what others have given up meanwhile.
  /// Nothing changes here until `committed`.
  std::vector<storage::PutOccupancy> claim(const Route& route, std::uint32_t from, std::uint32_t through) const;
  void committed(const std::vector<storage::PutOccupancy>& occupancies);

  /// Takes the holder's report that nothing before `from` is touched any more.
  void freed(const RobotId& robot, const RouteId& route, std::uint32_t from);
  /// Takes the holder's report that it stands there, and follows no route (any more).
  void stands(const msg::RobotState& state, Now now);
  /// Takes the report of a robot that has lost its route: where it stands is held, too, until it follows a route
  /// again. What it held stays held, as an order for that may be on its way.
  void stands_without_route(const msg::RobotState& state);
  /// Notes that the robot follows the route that it holds.
  void follows(const RobotId& robot);
  /// Takes an operator's word that the robot is not there. It holds nothing until it reports another place.
  Result<std::string> clear(const RobotId& robot, const std::string& who, Now now);
  /// Takes the route from the robot, as an operator asked. It holds where it stands: `at`, or else the first place it
  /// held.
  Result<std::string> clear_route(const RobotId& robot, const std::optional<PlaceId>& at, const std::string& who,
                                  Now now);

  void set_footprint(const RobotId& robot, double radius_m);
  void joined(const Batch& batch);
  /// Takes in an edit of the map. What is held stays held, on the map on which it was given.
  void edited(const Snapshot& before);
  /// Does one bounded piece of laying out the map, if there is any to do.
  void tick(Now now);
  std::optional<SteadyTime> next() const;
  /// Decides what is near what, for whoever plans.
  Proximity& proximity() { return proximity_; }
  bool is_laying_out() const { return proximity_.layout().has_work(); }
  /// Returns the robots that hold something, by the part of the map in which they are; those of which that is not
  /// known yet are in none.
  std::vector<std::vector<RobotId>> by_part();
  /// Returns whether somebody holds a place that is out of the map.
  bool holds_what_is_out() const;
  std::set<PlaceId> held_places() const;

  /// Returns the robots that hold something that one which stands at the place could touch, without `except`.
  std::set<RobotId> near(const PlaceId& place, const RobotId& except);
  /// Returns the robots that hold something.
  std::vector<RobotId> holding() const;
  /// Returns what the robot holds; null: nothing.
  const storage::PutOccupancy* held(const RobotId& robot) const;
  bool holds_route(const RobotId& robot, const RouteId& route) const;
  /// Counts up whenever a robot may have come to another part of the map.
  std::uint64_t parts_version() const { return parts_version_; }

 private:
  struct Holder {
    storage::PutOccupancy occupancy;  ///< empty places: nothing
    double footprint_m = 0.0;
    bool is_stored = true;              ///< the store has it like this
    std::optional<Touched> intruding;   ///< where it stands although somebody else holds that
    std::optional<Touched> led_on;      ///< where it may be, as it names a place that has not come yet
    std::optional<PlaceId> cleared_at;  ///< where an operator says that it is not
    bool moves_away = false;            ///< out of what somebody else holds, a piece at a time
    double beside_m = 0.0;              ///< how far from its place it stood when it said so last
  };

  // traffic_way.cpp
  Way held_back(const RobotId& robot);
  void go_on(const Route& route, std::uint32_t from, const Stops* stops, Way& way);
  void end_at_stop(const Route& route, const std::vector<Touched>& wanted, std::uint32_t from, const Stops& stops,
                   Way& way);
  std::set<RobotId> standing_near(const RobotId& robot, const Touched& there);
  bool move_away(const Route& route, std::uint32_t from, Way& way);
  static bool has_driven(const Holder& holder, std::uint32_t stand);
  std::optional<std::uint32_t> away_through(const Route& route, std::uint32_t stand,
                                            const std::vector<Touched>& ahead, const std::set<RobotId>& inside);
  std::vector<double> clearances_m(const std::set<RobotId>& robots, const LocatedPlace& here) const;
  void watch(const RobotId& robot, const Way& way);
  std::optional<RobotId> other_that_drives(const RobotId& robot) const;

  void lay_out_at_once();
  Holder& holder(const RobotId& robot);
  std::vector<Touched> touched(const Holder& holder) const;
  TrafficMap map() const { return {context_.snapshots.current(), history_}; }
  void load_history(Now now);
  void drop_history();
  std::set<RobotId> holders_near(const LocatedPlace& here, const RobotId& except);
  void hold(const RobotId& robot, const Holder& holder);
  void map_changed();
  void tell_of_layout(Now now);
  void follow_lead(Holder& holder, const msg::RobotState& state);
  bool is_there_still(const Holder& holder, const msg::RobotState& state);
  void settle(const RobotId& robot, Holder& holder, const msg::RobotState& state, Now now);
  bool store(const RobotId& robot, Holder& holder, storage::PutOccupancy next, Now now);

  Context& context_;
  Proximity proximity_;
  std::map<RobotId, Holder> holders_;
  TrafficMap::History history_;  ///< that have what is held and out of the map; usually none
  Holdings holdings_;
  Watches watches_;
  std::uint64_t laid_moves_ = 0;  ///< of the layout, when holdings were looked up in it last
  std::uint64_t parts_version_ = 1;
  SteadyTime next_piece_;             ///< of laying out the map
  std::uint64_t laid_told_ = 0;       ///< places, when that was told last
  bool is_layout_announced_ = false;  ///< it takes a while: people are told how far it is
};

}  // namespace weft::server
