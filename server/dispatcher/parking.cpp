#include <algorithm>
#include <chrono>
#include <utility>

#include "core/network/rules.hpp"
#include "server/dispatcher/dispatcher.hpp"

/// Sends idle robots that stand in the way to parking places, and gives robots goals of the server's own.
namespace weft::server {
namespace {
using namespace std::chrono_literals;
constexpr Duration kParksAfter = 10s;

/// Returns whether somebody can come by there: from one neighbouring place, and on to another one.
bool is_on_a_lane(const Snapshot& network, const PlaceId& place) {
  std::set<PlaceId> from;
  std::set<PlaceId> to;
  network.for_each_edge(place, [&](const Edge& edge) {
    const PlaceId other = other_end(edge, place);
    if (can_drive(edge, other)) from.insert(other);
    if (can_drive(edge, place)) to.insert(other);
  });
  return std::ranges::any_of(from, [&](const PlaceId& before) {
    return std::ranges::any_of(to, [&](const PlaceId& after) { return after != before; });
  });
}

}  // namespace

/// Says something of a robot once, until it is sent to a charger.
void Dispatcher::say_once(const Robot& robot, const char* kind, const std::string& cause, Now now) {
  if (!own_goals_.said[robot.id].insert(kind).second) return;
  context_.writer.note({.at = {}, .kind = kind, .robot = robot.id, .goal = {}, .cause = cause, .who = robot.name},
                       now);
}

/// Looks at every robot that has nothing to do: it charges, or parks.
void Dispatcher::send_idle_robots(Now now) {
  send_low_to_chargers(now);
  give_up_taken_spots(now);
  for (const auto& [id, robot] : fleet_.robots()) {
    if (!not_ready(robot).empty()) {
      own_goals_.idle_since.erase(id);
      continue;
    }
    const SteadyTime since = own_goals_.idle_since.try_emplace(id, now.steady).first->second;
    if (now.steady - since < kParksAfter) continue;
    say_unknown_charge(robot, now);
    park(robot, now);
  }
}

/// Sends the robot to the nearest free parking place, when it stands in the way and is at work no longer.
void Dispatcher::park(const Robot& robot, Now now) {
  const std::vector<PlaceId> spots = spots_of(context_.snapshots.current(), RuleKind::parking);
  if (spots.empty() || is_handling(robot.id, now) || !has_to_park(robot)) return;
  const std::vector<PlaceId> free = free_spots(robot.id, spots);
  const std::optional<Path> way = free.empty() ? std::nullopt : nearest(robot, free, now);
  const bool is_sent = way && send_by_itself(robot, GoalKind::park, *way, robot.name + " parks", now);
  if (!is_sent) own_goals_.idle_since[robot.id] = now.steady;
}

/// Returns whether the robot came to an operator's goal so short ago that it is at work there.
bool Dispatcher::is_handling(const RobotId& robot, Now now) const {
  const auto arrived = arrived_at_.find(robot);
  return arrived != arrived_at_.end() && now.steady - arrived->second < from_seconds(context_.config.handling_s);
}

/// Returns whether an idle robot stands where others come by. One that charges stays, until it is full and another
/// one comes.
bool Dispatcher::has_to_park(const Robot& robot) {
  const PlaceId& place = robot.state->place;
  const RuleMap& rules = routes_.rules();
  if (rules.is_of(place, RuleKind::parking)) return false;
  const bool is_charging = rules.is_of(place, RuleKind::charging);
  if (is_charging && !own_goals_.charge.is_full(robot.id)) return false;
  if (!is_charging && is_on_a_lane(context_.snapshots.current(), place)) return true;
  return std::any_of(book_.alive().begin(), book_.alive().end(), [&](const auto& entry) {
    const Goal& goal = *book_.find(entry.second);
    const bool is_own = goal.robot == robot.id || goal.wanted == robot.id;
    return !is_own && traffic_.near(goal.to, {}).contains(robot.id);
  });
}

/// Returns the spots at which no robot stands or drives by, and to which none goes that moves by itself. A robot that
/// is idle and full at a charger makes way, and takes no spot.
std::vector<PlaceId> Dispatcher::free_spots(const RobotId& robot, const std::vector<PlaceId>& spots) {
  const auto makes_way = [this](const RobotId& other) {
    const Robot* const known = fleet_.find(other);
    return known != nullptr && not_ready(*known).empty() && own_goals_.charge.is_full(other) &&
           routes_.rules().is_of(known->state->place, RuleKind::charging);
  };
  std::vector<PlaceId> free;
  for (const PlaceId& spot : spots) {
    const bool is_wanted = std::any_of(assignments_.begin(), assignments_.end(), [&](const auto& entry) {
      const bool goes_on = entry.first != robot && !entry.second.is_over() && !stays(entry.first);
      return goes_on && book_.find(entry.second.goal)->to == spot;
    });
    if (!is_wanted && std::ranges::all_of(traffic_.near(spot, robot), makes_way)) free.push_back(spot);
  }
  return free;
}

/// Returns the shortest way to one of the places; none: no way leads to any.
std::optional<Path> Dispatcher::nearest(const Robot& robot, const std::vector<PlaceId>& places, Now now) {
  const Candidate from = candidate_of(robot);
  std::optional<Path> shortest;
  for (const PlaceId& place : places) {
    Result<Path> way = ways_to(place, now)(from);
    if (way && (!shortest || way->length_m < shortest->length_m)) shortest = *std::move(way);
  }
  return shortest;
}

/// Makes a goal of the server's own, for one robot alone; not yet stored.
Goal Dispatcher::own_goal(GoalKind kind, RobotId robot, const PlaceId& to) {
  Goal goal;
  for (std::uint8_t& byte : goal.id.bytes) byte = static_cast<std::uint8_t>(random_.next());
  goal.kind = kind;
  goal.to = to;
  goal.wanted = robot;
  goal.robot = robot;
  goal.number = book_.next_number();
  return goal;
}

/// Gives the robot a goal of the server's own, which ends by itself. False: the store takes nothing.
bool Dispatcher::send_by_itself(const Robot& robot, GoalKind kind, const Path& way, const std::string& cause,
                                Now now) {
  Goal goal = own_goal(kind, robot.id, way.places.back());
  goal.label = to_string(kind);
  const GoalBook::Step step = {.state = GoalState::assigned,
                               .cause = cause + ", at " + to_string(goal.to),
                               .who = "traffic",
                               .kind = kind == GoalKind::charge ? "traffic.charges" : "traffic.parks"};
  return give(goal, step, {.robot = robot.id, .path = way}, now);
}

/// Ends goals of the server's own at places where somebody stands who cannot be asked to make way.
void Dispatcher::give_up_taken_spots(Now now) {
  for (const auto& [id, robot] : fleet_.robots()) {
    const auto found = assignments_.find(id);
    if (found == assignments_.end() || found->second.is_over()) continue;
    const Goal& goal = *book_.find(found->second.goal);
    if (goal.kind != GoalKind::charge && goal.kind != GoalKind::park) continue;
    for (const RobotId& other : traffic_.near(goal.to, id)) {
      const std::optional<Stays> why = stays(other);
      if (!why || *why == Stays::idle) continue;
      finish(id, found->second, GoalState::cancelled, fleet_.name_of(other) + " stands there", "traffic", now);
      break;
    }
  }
}

/// Ends the parking of a robot that could have the goal, for which nobody is ready. Returns whether one is, or was.
bool Dispatcher::recall_from_parking(const Goal& goal, Now now) {
  std::vector<Candidate> parking;
  for (const auto& [id, assignment] : assignments_) {
    const Goal& own = *book_.find(assignment.goal);
    const Robot* const robot = fleet_.find(id);
    const bool is_asked = !goal.wanted || *goal.wanted == id;
    if (own.kind != GoalKind::park || !is_asked || robot == nullptr) continue;
    // The one that was recalled before will be ready soon.
    if (assignment.is_over() && own.state == GoalState::cancelled) return true;
    const bool is_there = unreachable_reason(*robot).empty() && robot->state && robot->state->localised;
    const bool may_go = !assignment.is_over() && is_there && why_held(id).empty() && own.state != GoalState::paused;
    if (may_go && why_recharging(*robot).empty()) parking.push_back(candidate_of(*robot));
  }
  if (parking.empty()) return false;
  const Result<Choice> choice = choose(parking, ways_that_charge_covers(goal, now));
  if (!choice) return false;
  finish(choice->robot, assignments_.at(choice->robot), GoalState::cancelled, "a goal of an operator comes first",
         "traffic", now);
  return true;
}

}  // namespace weft::server
