#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "server/base/context.hpp"
#include "server/dispatcher/capacity.hpp"
#include "server/dispatcher/choice.hpp"
#include "server/dispatcher/goal_book.hpp"
#include "server/dispatcher/own_goals.hpp"
#include "server/dispatcher/planning.hpp"
#include "server/dispatcher/turns.hpp"
#include "server/eta/arrivals.hpp"
#include "server/fleet/fleet.hpp"
#include "server/routes/routes.hpp"
#include "server/traffic/overlay.hpp"
#include "server/traffic/traffic.hpp"
#include "server/traffic/waits.hpp"

namespace weft::server {

/// Returns the methods that the robot can drive; it has described itself.
inline std::set<std::string> methods_of(const Robot& robot) {
  return {robot.description->methods.begin(), robot.description->methods.end()};
}

/// Leads every goal through its life (docs/path-of-a-goal.md): gives it to a robot, plans its route, has it released
/// by traffic, sends the order until the robot has it, and follows its progress to the end.
class Dispatcher {
 public:
  /// Takes up goals that were under way where they were.
  Dispatcher(Context& context, Fleet& fleet, Traffic& traffic, Routes& routes, Arrivals& arrivals, Random random,
             std::map<GoalId, Goal> goals, std::map<GoalId, Route> given, SteadyTime now);

  // These do what operators ask for. Each leaves the request's number, sender and header to the caller.
  msg::OperatorReply send(const msg::OperatorRequest& request, const std::string& who, Now now);
  msg::OperatorReply cancel(const GoalId& id, const std::string& who, Now now);
  /// Takes the goal from a robot that is not heard, for any other. Refused when the robot is heard, or the goal was
  /// asked for it alone.
  msg::OperatorReply hand_over(const GoalId& id, const std::string& who, Now now);
  /// Stops or continues the robot's goal, if it has one; returns a text of what happened.
  Result<std::string> pause(const RobotId& robot, const std::string& who, Now now);
  Result<std::string> resume(const RobotId& robot, const std::string& who, Now now);
  /// Takes an operator's word that the robot is away: its goal fails, and what it held is free. When the robot is
  /// heard, only its route is freed, and that is refused unless `is_sure`.
  Result<std::string> clear(const RobotId& robot, bool is_sure, const std::string& who, Now now);

  /// Looks at the robot's release again: an operator holds it, or does no longer.
  void held_or_freed(const RobotId& robot);
  /// Fails the pending goals for that robot alone: it is no longer in the fleet.
  void fail_waiting_for(const RobotId& robot, const std::string& why, const std::string& who, Now now);

  // These take robots' reports.
  void on_state(const Robot& robot, Now now);
  void on_progress(const msg::RouteProgress& progress, Now now);
  /// Notes that the robot's agent was restarted and has forgotten its route.
  void on_restart(const RobotId& robot);

  void network_changed();
  /// Has routes under way checked at the next tick: something left the map or came back.
  void network_edited() {
    routes_checked_ = false;
    planning_.map_edited();
  }
  void tick(Now now);
  /// Leaves out of every wait for a robot's word what the server itself was away.
  void excuse(Duration away, SteadyTime now);
  std::optional<SteadyTime> next() const;

  const GoalBook& book() const { return book_; }
  /// Returns the goal that keeps the robot busy; none when it is free for another.
  const Goal* goal_of(const RobotId& robot) const;

  // waiting.cpp
  /// Returns the robots that stand at the end of what they were released, and for whom.
  std::vector<Wait> waits();
  /// Returns why the robot does not move by itself; none: it may.
  std::optional<Stays> stays(const RobotId& robot) const;

  // foretell.cpp
  /// Returns when a robot comes to that goal; none: no robot is on its way, or something keeps it that nobody knows
  /// the end of.
  std::optional<msg::Arrival> arrival(const Goal& goal) const;

  bool has_assignments() const { return !assignments_.empty(); }

 private:
  /// Holds what the server and a robot still have to settle about one route.
  struct RouteAssignment {
    /// Names what the server and the robot have to settle first.
    enum class Standing {
      followed,  ///< nothing: the robot follows the route, or is to
      lost,      ///< the robot has no such route any more: plan from where it stands
      recalled,  ///< what the robot drives on has left the map: it is to forget the route, and stand
      over,      ///< the goal is over, the robot is still to forget the route
    };

    GoalId goal;
    Standing standing = Standing::followed;
    bool has_latest_order = false;               ///< it answered to this version and release
    std::optional<std::uint64_t> latest_report;  ///< sequence of its latest report on this version
    std::uint32_t at = 0;                        ///< index of the last place passed, by that report
    std::optional<SteadyTime> ordered_at;        ///< last order to follow it
    SteadyTime send_at;
    Duration wait{};
    bool cut_short = false;  ///< the route leads to its released point and no farther: the map has changed
    bool is_closed = false;  ///< the robot takes no more orders for the route's id
    std::optional<SteadyTime> missing_since;
    SteadyTime plan_at;
    SteadyTime given_at;              ///< when it was given: the longer ago, the sooner its turn comes
    bool look_at_release = true;      ///< traffic may now release more than it did
    Traffic::Way way;                 ///< as traffic said last
    Traffic::Way noted_way;           ///< what it waits for, as it was told
    std::string ruled_by;             ///< the name of the rule that ends its release; empty: none does
    bool was_bent = false;            ///< the robot could not drive as it was led, and was given another way for that
    std::string noted_rule;           ///< the rule that ends its release, as people were told
    std::optional<Now> waits_since;   ///< since when it was released no farther
    bool stands_at_end = false;       ///< the robot said that it stands at the end of its latest order
    bool is_hand_over_asked = false;  ///< people were told that another robot could have the goal
    bool is_silence_told = false;     ///< and that its robot is not heard

    bool is_lost() const { return standing == Standing::lost; }
    bool is_over() const { return standing == Standing::over; }
    /// Returns whether the robot is to forget the route.
    bool is_to_end() const { return standing == Standing::recalled || standing == Standing::over; }
    void lose() { standing = Standing::lost; }
    /// Takes a loss back: the robot has the route after all.
    void find_again() {
      if (is_lost()) standing = Standing::followed;
    }
  };

  // assign.cpp
  std::vector<const Goal*> pending() const;
  bool assign_waiting(Now now);
  bool assign(const Goal& goal, const Choice& choice, Now now);
  bool give(const Goal& goal, const GoalBook::Step& step, const Choice& choice, Now now);
  Candidate candidate_of(const Robot& robot) const;
  /// Tells why a goal is not given to a robot: the robots have others first or are not ready, there is no way, or
  /// another robot comes first where it leads.
  enum class Why : std::uint8_t { turn, no_way, taken };
  /// Collects what one look at all pending goals finds.
  struct Queues {
    struct Waits {
      GoalBook::Waiting goal;
      Why kind = Why::turn;
    };
    std::set<std::optional<RobotId>> begun;  ///< for whom a goal waits; none: for any robot
    std::vector<Waits> waiting;              ///< what is to be noted
    std::set<PlaceId> places;                ///< to which a goal waits to be given out, as another robot comes first
  };
  void still_pending(const Goal& goal, Why kind, const std::string& why, Queues& queues) const;
  void note_pending(const Queues& queues, Now now);
  void forget_waiting(const GoalId& goal);
  std::string not_ready(const Robot& robot) const;
  std::vector<Candidate> candidates(const Goal& goal, std::string& why_none) const;
  void wait_for(const Goal& goal, const std::string& why, Now now);
  void replan(const RobotId& robot, RouteAssignment& assignment, Now now);
  Route route_of(const Goal& goal, const Choice& choice);
  FindWay ways_to(const PlaceId& to, Now now);
  FindWay ways_for(const Goal& goal, Now now);
  Result<Path> way_of(const Candidate& candidate, const PlaceId& to, const ClosedHops* closed, SteadyTime now);
  RouteId new_route_id();
  std::string no_return(const Goal& goal) const;

  Result<std::string> clear_heard(const Robot& robot, const std::string& who, Now now);
  Result<void> fail_goal(const RobotId& robot, const std::string& cause, const std::string& who, Now now);

  // hand_over.cpp
  std::string keeps_goal(const RobotId& robot, const RouteAssignment& assignment) const;
  Result<void> hand_over(const RobotId& robot, const std::string& cause, const std::string& who, Now now);
  void look_at_silent(Now now);
  void tell_silence(const RobotId& robot, RouteAssignment& assignment, Now now);
  std::optional<SteadyTime> next_look_at_silent() const;

  // charging.cpp
  void look_at_charge(Now now);
  void send_low_to_chargers(Now now);
  void send_to_charger(const RobotId& id, const std::vector<PlaceId>& chargers, Now now);
  std::string why_recharging(const Robot& robot) const;
  std::optional<int> charge_that_counts(const RobotId& robot) const;
  FindWay ways_that_charge_covers(const Goal& goal, Now now);
  double way_on_m(const PlaceId& from, const std::vector<PlaceId>& chargers, const Candidate& drives, Now now);
  void note_fell_short(Now now);
  void say_unknown_charge(const Robot& robot, Now now);

  // parking.cpp
  void say_once(const Robot& robot, const char* kind, const std::string& cause, Now now);
  void send_idle_robots(Now now);
  void park(const Robot& robot, Now now);
  bool is_handling(const RobotId& robot, Now now) const;
  bool has_to_park(const Robot& robot);
  std::vector<PlaceId> free_spots(const RobotId& robot, const std::vector<PlaceId>& spots);
  std::optional<Path> nearest(const Robot& robot, const std::vector<PlaceId>& places, Now now);
  Goal own_goal(GoalKind kind, RobotId robot, const PlaceId& to);
  bool send_by_itself(const Robot& robot, GoalKind kind, const Path& way, const std::string& cause, Now now);
  void give_up_taken_spots(Now now);
  bool recall_from_parking(const Goal& goal, Now now);

  // place_queue.cpp
  std::optional<RobotId> who_comes_first_at(const Goal& goal, const std::vector<Candidate>& ready, Now now);
  bool is_at_rest(const RobotId& robot) const;
  std::string why_another_first(const Goal& goal, const std::vector<Candidate>& ready, Queues& queues, Now now);

  // reroute.cpp
  void reroute(const RobotId& robot, RouteAssignment& assignment, Now now);
  void replan_ahead(const RobotId& robot, RouteAssignment& assignment, Now now);
  void limit_anew(const RobotId& robot, RouteAssignment& assignment, Now now);
  void put_version(const RobotId& robot, RouteAssignment& assignment, const Route& next, const GoalBook::Step& step,
                   Now now);
  void cut_off(const RobotId& robot, RouteAssignment& assignment, const std::string& why, Now now);
  void recall(const RobotId& robot, RouteAssignment& assignment, const std::string& why, Now now,
              const char* kind = "goal.waits");

  // moves.cpp
  bool needs_plan() const;
  bool is_led(const RouteAssignment& assignment) const;
  bool is_waited_for(const RobotId& robot) const;
  void plan_moves(Now now);
  void begin_plan(Now now);
  std::optional<PlaceId> led_to(const RobotId& robot) const;
  PlanRequest plan_request(const RobotId& robot, Now now) const;
  std::set<PlaceId> avoided_by(const RobotId& robot, SteadyTime now) const;
  void lead(PlanRequest& request, const RouteAssignment& assignment, Now now) const;
  void ask_to_make_way(const RobotId& robot, Now now);
  void begin_yield(Route route, std::uint32_t through, Now now);

  // release.cpp
  /// Holds what a route can be released next, and of which way.
  struct Piece {
    Route route;  ///< with the places that are planned
    Traffic::Stops stops;
    Traffic::Way way;
    std::optional<std::uint32_t> reach;  ///< how far nobody is in the way, of what is not the robot's turn
  };
  bool release(const RobotId& robot, RouteAssignment& assignment, Now now);
  void release_some(Now now);
  bool has_to_release() const { return release_from_.has_value() || !to_make_way_.empty(); }
  std::optional<Piece> next_piece(const RobotId& robot, const Goal& goal, const Route& route, bool told, Now now);
  void name_what_is_beyond(Piece& piece);
  void name_who_cuts_off(Piece& piece, const RobotId& by, std::size_t kept);
  std::string end_by_rules(const RobotId& robot, std::uint32_t kept, bool told, Piece& piece) const;
  std::optional<Route> led_along(const Goal& goal, const Route& route, bool told, const std::vector<PlaceId>& places,
                                 Now now);
  void grant(const RobotId& robot, RouteAssignment& assignment, const Piece& piece, bool told, Now now);
  std::string why_held(const RobotId& robot) const;
  bool keeps_limits(const RobotId& robot) const;
  std::optional<Wait> wait_at_barrier(const RobotId& robot, const RouteAssignment& assignment) const;
  std::optional<Wait> wait_without_route(const RobotId& robot, const RouteAssignment& assignment) const;
  Wait barred_wait(const RobotId& robot, const RouteAssignment& assignment, std::uint32_t from,
                   const Passage& passage) const;
  HeldPlaces held_by_others(const RobotId& robot) const;
  void note_waiting(const RobotId& robot, RouteAssignment& assignment, const Traffic::Way& way, Now now);
  std::string names_of(const std::set<RobotId>& robots) const;
  std::string why_it_stands(const Traffic::Way& way) const;
  std::string why_it_waits(const Traffic::Way& way) const;
  std::string why_it_goes_on(const Traffic::Way& way) const;

  // blocked.cpp
  void note_blocked(const Robot& robot, Now now);
  void close_ahead(const RobotId& robot, RouteAssignment& assignment, Now now);
  void note_driven(const Route& route, RouteAssignment& assignment, std::uint32_t at, Now now);
  void look_at_closures(Now now);
  void opened(const std::vector<Overlay::Opened>& all, const std::string& why, Now now);
  const ClosedHops* closed_for(const Goal& goal, const RobotId& robot) const;
  std::string closed_text(const GoalId& goal) const;

  // follow.cpp
  bool is_told(const RobotId& robot, const Route& route) const;
  void send_order(const RobotId& robot, RouteAssignment& assignment, SteadyTime now);
  void end_unknown(const RobotId& robot, const GoalId& goal, const RouteId& route);
  void avoid(const RobotId& robot, const Route& route, SteadyTime now);
  void finish(const RobotId& robot, RouteAssignment& assignment, GoalState state, const std::string& cause,
              const std::string& who, Now now);
  bool has_to_send(const RobotId& robot, const RouteAssignment& assignment) const;
  bool has_forgotten(const RouteAssignment& assignment, const msg::RobotState& state, const Route& route,
                     SteadyTime now) const;
  void watch_for_loss(RouteAssignment& assignment, const Route& route, const msg::RobotState& state, SteadyTime now);

  Context& context_;
  Fleet& fleet_;
  Traffic& traffic_;
  Routes& routes_;
  Arrivals& arrivals_;
  Random random_;
  GoalBook book_;
  Planning planning_;
  Overlay overlay_;
  std::deque<RobotId> to_make_way_;      ///< robots without a goal, to be asked if the plan has them move
  std::optional<RobotId> release_from_;  ///< from which robot on releases are still to be looked at
  std::map<RobotId, SteadyTime> blocked_since_;
  std::set<RobotId> blocked_for_long_;        ///< others are led round them
  std::map<RobotId, SteadyTime> arrived_at_;  ///< where an operator sent it
  /// Holds where a robot could not drive when it was to make way, and until when it is not asked to again.
  std::map<RobotId, std::map<PlaceId, SteadyTime>> avoids_;
  std::map<RobotId, RouteAssignment> assignments_;
  std::map<GoalId, std::vector<Candidate>> tried_;  ///< with whom a waiting goal was tried in vain, last
  std::map<GoalId, Choosing> choosing_;             ///< of waiting goals: searches that go on
  std::map<GoalId, std::set<Why>> told_;            ///< what a pending goal has said since the server started
  Turns turns_;
  OwnGoals own_goals_;
  bool decides_by_charge_ = false;  ///< the map has chargers
  Revision tried_at_;
  RuleMap seen_rules_;  ///< as routes under way were checked against them
  bool routes_checked_ = false;
  bool look_again_ = true;
  SteadyTime look_at_;
  SteadyTime look_at_silent_{};
};

}  // namespace weft::server
