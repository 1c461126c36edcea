#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "core/network/rules.hpp"
#include "server/dispatcher/dispatcher.hpp"

/// Decides by robots' charge which robot takes a goal, and which is sent to a charger (docs/decisions/074). Without a
/// rule of kind charging on the map, charge decides nothing.
namespace weft::server {
namespace {

std::string whole_percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

std::string whole_metres(double way_m) {
  return std::to_string(std::lround(way_m)) + " m";
}

}  // namespace

/// Takes what robots have said of their batteries, and sends those that are critical to chargers: that comes before
/// their next goals.
void Dispatcher::look_at_charge(Now now) {
  const std::vector<PlaceId> chargers = spots_of(context_.snapshots.current(), RuleKind::charging);
  decides_by_charge_ = !chargers.empty();
  if (!decides_by_charge_) return;
  for (const auto& [id, robot] : fleet_.robots()) {
    if (robot.power) own_goals_.charge.take(id, robot.power->share, robot.power->is_charging, now.steady);
  }
  for (const RobotId& robot : own_goals_.charge.queue()) {
    if (own_goals_.charge.is_critical(robot)) send_to_charger(robot, chargers, now);
  }
}

/// Sends robots that are low, and have got no goal, to chargers.
void Dispatcher::send_low_to_chargers(Now now) {
  if (!decides_by_charge_) return;
  const std::vector<PlaceId> chargers = spots_of(context_.snapshots.current(), RuleKind::charging);
  for (const RobotId& robot : own_goals_.charge.queue()) send_to_charger(robot, chargers, now);
}

/// Gives the robot a goal at the nearest free charger, when it is ready for one and not at a charger.
void Dispatcher::send_to_charger(const RobotId& id, const std::vector<PlaceId>& chargers, Now now) {
  const Robot* const robot = fleet_.find(id);
  if (robot == nullptr || !not_ready(*robot).empty()) return;
  if (routes_.rules().is_of(robot->state->place, RuleKind::charging)) return;
  const std::vector<PlaceId> free = free_spots(id, chargers);
  const std::string charge = robot->name + " has " + std::to_string(*own_goals_.charge.percent(id)) + " %";
  if (free.empty()) return say_once(*robot, "robot.waits_for_charger", charge + ": all chargers are taken", now);
  const std::optional<Path> way = nearest(*robot, free, now);
  if (!way) {
    return say_once(*robot, "robot.no_way_to_charger",
                    charge + ", and there is no way from where it stands to a charger that is free", now);
  }
  if (!send_by_itself(*robot, GoalKind::charge, *way, charge + ": it goes to a charger", now)) return;
  own_goals_.charge.sent(id);
  own_goals_.said.erase(id);
}

/// Says for people why a robot that could go takes no goals: it charges; empty: it takes them.
std::string Dispatcher::why_recharging(const Robot& robot) const {
  if (!decides_by_charge_ || !own_goals_.charge.is_recharging(robot.id)) return {};
  return robot.name + " is to charge, and takes goals from " + whole_percent(context_.config.charge.enough) + " on";
}

/// Returns what the robot has, where that counts, in whole percent: ways are searched again when it is another one.
std::optional<int> Dispatcher::charge_that_counts(const RobotId& robot) const {
  return decides_by_charge_ ? own_goals_.charge.percent(robot) : std::nullopt;
}

/// Finds ways that a robot's charge covers, with the way on to the nearest charger. A place from which none leads to
/// a charger needs none.
FindWay Dispatcher::ways_that_charge_covers(const Goal& goal, Now now) {
  if (!decides_by_charge_) return ways_for(goal, now);
  const std::vector<PlaceId> chargers = spots_of(context_.snapshots.current(), RuleKind::charging);
  using Drivers = std::pair<std::set<std::string>, bool>;
  const auto known = std::make_shared<std::map<Drivers, double>>();
  own_goals_.fell_short.clear();
  return [this, to = goal.to, now, chargers, known,
          ways = ways_for(goal, now)](const Candidate& from) -> Result<Path> {
    Result<Path> way = ways(from);
    if (!way || !from.percent) return way;
    const auto [on, is_new] = known->try_emplace(Drivers{from.methods, from.keeps_limits}, 0.0);
    if (is_new) on->second = way_on_m(to, chargers, from, now);
    const double needed = share_for(context_.config.charge, way->length_m + on->second);
    if (0.01 * *from.percent >= needed) return way;
    own_goals_.fell_short.insert(from.robot);
    return fail(ErrorCode::refused, "what " + fleet_.name_of(from.robot) + " has charged does not cover " +
                                        whole_metres(way->length_m) + " to there and " + whole_metres(on->second) +
                                        " on to a charger: that needs " + whole_percent(needed));
  };
}

/// Returns how far it is from the place to the nearest charger, for whoever drives like that; 0: no way leads to one.
double Dispatcher::way_on_m(const PlaceId& from, const std::vector<PlaceId>& chargers, const Candidate& drives,
                            Now now) {
  std::optional<double> shortest_m;
  for (const PlaceId& charger : chargers) {
    const Result<Path> way = routes_.find_allowed(from, charger, drives.methods, drives.keeps_limits, now.steady);
    if (way) shortest_m = std::min(shortest_m.value_or(way->length_m), way->length_m);
  }
  return shortest_m.value_or(0.0);
}

/// Has robots charge whose charge did not cover a goal that nobody could be given.
void Dispatcher::note_fell_short(Now now) {
  if (!decides_by_charge_) return;
  for (const RobotId& robot : std::exchange(own_goals_.fell_short, {}))
    own_goals_.charge.fell_short(robot, now.steady);
}

/// Says once of each idle robot that does not know its charge that nothing is decided by it.
void Dispatcher::say_unknown_charge(const Robot& robot, Now now) {
  if (!decides_by_charge_ || own_goals_.charge.percent(robot.id)) return;
  say_once(robot, "robot.charge_unknown",
           "it does not say what its battery holds: goals are given to it whatever that is, and it is not sent to a "
           "charger",
           now);
}

}  // namespace weft::server
