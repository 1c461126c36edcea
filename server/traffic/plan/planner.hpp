#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "server/traffic/plan/berths.hpp"
#include "server/traffic/plan/distances.hpp"
#include "server/traffic/plan/lanes.hpp"
#include "server/traffic/plan/led_robots.hpp"
#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/move_steps.hpp"
#include "server/traffic/plan/plan_order.hpp"
#include "server/traffic/plan/safe_states.hpp"

namespace weft::server {

/// Describes a robot whose moves are to be planned.
struct PlanRequest {
  RobotId robot;
  std::vector<PlaceId> held;    ///< what it was released and has not left, in order; it stands at the last one then
  std::optional<PlaceId> goal;  ///< none: it makes way if it is asked to
  std::vector<PlaceId> ahead;   ///< its way to the goal beyond what is held, as it was found last
  Drives drives;
  std::set<PlaceId> avoids;      ///< it could not drive there
  bool stays = false;            ///< it does not move, and cannot be asked to
  bool stands_for_long = false;  ///< others are led round it
  bool needs_help = false;       ///< and it does so until a person helps
  std::uint32_t handles = 0;     ///< steps of a berth for which it cannot be asked to
  std::uint8_t priority = 0;
  double waits_s = 0.0;  ///< since its goal was asked for
};

/// Tells how a robot goes on.
struct PlannedWay {
  std::vector<PlaceId> places;       ///< beyond what it holds
  std::vector<std::uint32_t> stops;  ///< of these, by index: where it may stand
};

/// Plans the next moves of all robots over the berths of the map, at once or a piece at a time.
class Planner {
 public:
  Planner(Proximity& proximity, PlanRules rules) : berths_(proximity), rules_(rules) {}

  /// Has what can be touched looked up in that map from now on, as `Berths::see`.
  void see(std::shared_ptr<const Snapshot> latest) { berths_.see(std::move(latest)); }
  /// Plans anew for all of them; `footprint_m` is that of the largest. Robots that stand where the map has no place
  /// are left out. The robots' numbers, below, are those of the requests. Where `may_lag`, the map and the layout may
  /// be those of an earlier plan, if all that the requests name lies in that: to cut a map into berths again takes
  /// what the map does. So they may where it is not known yet where all of these lie in the latest; then nobody moves
  /// unless the earlier one has them. Returns whether it is the latest.
  bool plan(const RuledNetwork& network, double footprint_m, const std::vector<PlanRequest>& requests,
            bool may_lag = false);
  /// Begins that plan. Until it is made there is none: nobody may move, and nothing else may be asked.
  bool begin(const RuledNetwork& network, double footprint_m, std::vector<PlanRequest> requests,
             bool may_lag = false);
  bool is_under_way() const { return making_.has_value(); }
  /// Goes on with the plan until so much is done (the unit is that of `MoveSteps`), little more, and at least a
  /// little. The plan does not depend on how it is divided.
  void work(std::uint64_t most);
  /// Counts what was done, in that unit; only differences mean anything.
  std::uint64_t done() const { return done_ + berths_.looked_up() + lanes_.searches(); }
  /// Returns the robot's planned moves from `first` to before `last`.
  PlannedWay way(std::uint32_t robot, std::uint32_t first, std::uint32_t last) const;
  /// Returns how many of its planned moves the robot may be released now, those included that have been; `held`
  /// berths of what it was released lie ahead of it. Follows the plan's order, and releases little at a time while
  /// others move, or are to make way, as what the robot holds is in their way. One without a goal does not go to and
  /// fro between berths that touch one another.
  std::uint32_t may(std::uint32_t robot, std::uint32_t held);
  /// Returns the robots that this one waits for, as `PlanOrder::waits_for`; when the order lets it move, those that
  /// have not yet reached where the plan has them, so that its move would have to be taken back.
  std::vector<std::uint32_t> waits_for(std::uint32_t robot);
  /// Returns the robot that cuts this one off from its goal; kNobody: none does.
  std::uint32_t cut_off_by(std::uint32_t robot) const { return cut_off_by_[robot]; }
  /// Returns whether the robot may drive on to the next berth of that way though the plan does not say so: nobody
  /// comes face to face with it there, or is stuck.
  bool is_safe(std::uint32_t robot, const std::vector<PlaceId>& ahead);
  /// Notes that so many of the robot's moves are released.
  void release(std::uint32_t robot, std::uint32_t moves);
  /// Returns how many berths lie in what a robot holds, without the one where it ends.
  std::uint32_t berths_in(const std::vector<PlaceId>& held) const;
  /// Keeps the order of the plan.
  const PlanOrder& order() const { return order_; }
  /// Counts robots that were asked to make way, of all plans.
  std::uint64_t pushes() const { return pushes_; }
  std::uint64_t asked_several() const { return asked_several_; }

 private:
  using Key = std::pair<PlaceId, std::uint32_t>;

  /// Holds a plan that is being made.
  struct Making {
    /// Names what comes next.
    enum class Part : std::uint8_t { cut, number, describe, cut_off, move };
    /// Names what the moves are planned for: once more where robots that are cut off keep others, and where some are
    /// gridlocked first with those that go after others giving way to these, then with nobody asking the others, and
    /// last with one of them led away.
    enum class Round : std::uint8_t { all, without_cut_off, giving_way, gridlocked, led_away };

    Making(std::vector<PlanRequest> asked, Part first) : requests(std::move(asked)), part(first) {}

    std::vector<PlanRequest> requests;
    std::vector<PlanRobot> robots;
    Part part;
    Round round = Round::all;
    std::size_t next = 0;  ///< robot
    std::optional<MoveSteps> steps;
  };

  // planner_work.cpp
  void go_on(std::uint64_t most);
  void cut_more();
  void number_next();
  void describe_next();
  void cut_off_next();
  void move_on(std::uint64_t most);
  bool plans_anew(const MovePlan& plan);
  SafeStates standing(const std::vector<PlanRobot>& robots);
  bool leads_away_one(const MovePlan& plan, const std::vector<bool>& locked);
  void lead_on_as_before();
  void end_with(MovePlan plan);
  void send_on_as_before();
  void note_sent_on(const MovePlan& plan);
  bool has_searched(const PlanRequest& request);

  bool plan_nothing(std::size_t robots);
  bool is_laid(const Snapshot& network, const std::vector<PlanRequest>& requests) const;
  bool knows(const std::vector<PlanRequest>& requests) const;
  void occupy(const std::vector<PlanRequest>& requests);
  std::vector<Berth> held_by(const PlanRequest& request);
  PlanRobot robot_of(const PlanRequest& request);
  std::uint32_t cut_off_by(const PlanRequest& request, const PlanRobot& robot);
  PlaceId guide(const PlanRequest& request, std::uint32_t methods);
  Distances& distances(const PlaceId& to, std::uint32_t methods);
  void forget_unused();
  /// Returns whether that move of the robot leads it away from others, round all where they stood.
  bool is_led(std::uint32_t robot, std::uint32_t move) const { return move < led_moves_[robot]; }
  std::uint32_t without_return(std::uint32_t robot, std::uint32_t moves);
  void note_stood(std::uint32_t robot, std::uint32_t moves);

  Berths berths_;
  PlanRules rules_;
  std::vector<Berth> occupied_;            ///< for long
  std::map<Berth, std::uint32_t> lost_;    ///< of these: until a person helps that robot
  std::vector<std::uint32_t> cut_off_by_;  ///< of each robot of the plan: who does it; kNobody
  std::map<Key, std::unique_ptr<Distances>> distances_;
  Pockets pockets_{berths_};
  Lanes lanes_{berths_};
  PlanOrder order_;
  std::optional<SafeStates> released_;             ///< where robots are when they have driven what they were released
  std::vector<std::uint32_t> methods_;             ///< of each robot of the plan
  std::vector<std::uint32_t> led_moves_;           ///< of each: how many of its moves lead it away
  std::vector<std::optional<RobotId>> makes_way_;  ///< of each: who it is, where it has no goal
  std::map<RobotId, std::vector<Berth>> stood_;    ///< where robots without a goal stood that did not get away yet
  std::uint32_t moving_ = 0;                       ///< robots that have a goal, or are to make way
  std::set<Key> used_;
  /// Names whom a robot without a goal was found to keep from going where, by the plan before: that one may have been
  /// led off by now, to where no plan finds it kept before it has come back.
  struct SentOn {
    RobotId kept;
    PlaceId to;
  };
  std::map<RobotId, SentOn> sent_on_;
  std::map<RobotId, PlaceId> guides_;
  LedRobots led_;
  std::uint64_t pushes_ = 0;
  std::uint64_t asked_several_ = 0;
  std::optional<Making> making_;
  std::uint64_t done_ = 0;  ///< beside what is counted elsewhere
};

}  // namespace weft::server
