#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/network/beside.hpp"
#include "server/dispatcher/dispatcher.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;
constexpr Duration kBetweenRoutePlans = 1s;
constexpr std::size_t kStartsTried = 6;
/// Bounds how many ways are searched before messages are heard again.
constexpr std::size_t kWaysAtOnce = 50;

std::string metres(double length_m) {
  const auto centimetres = std::llround(length_m * 100);
  const std::string cents = std::to_string(centimetres % 100);
  return std::to_string(centimetres / 100) + (cents.size() == 1 ? ".0" : ".") + cents + " m";
}

}  // namespace

/// Returns why the robot cannot be given a goal; empty when it can.
std::string Dispatcher::not_ready(const Robot& robot) const {
  if (std::string why = unreachable_reason(robot); !why.empty()) return why;
  if (std::string why = why_held(robot.id); !why.empty()) return why;
  if (assignments_.contains(robot.id)) return robot.name + " has goal " + to_string(assignments_.at(robot.id).goal);
  if (!robot.state) return robot.name + " has not said yet where it is";
  if (!robot.state->localised || !robot.state->place) {
    return robot.name + " does not know where it is: weft localise " + robot.name;
  }
  if (robot.state->mode != msg::RobotMode::idle) return robot.name + " is " + to_string(robot.state->mode);
  return {};
}

std::vector<Candidate> Dispatcher::candidates(const Goal& goal, std::string& why_none) const {
  std::vector<Candidate> ready;
  for (const auto& [id, robot] : fleet_.robots()) {
    if (goal.wanted && *goal.wanted != id) continue;
    std::string why = not_ready(robot);
    if (why.empty()) why = why_recharging(robot);
    if (why.empty()) {
      ready.push_back(candidate_of(robot));
    } else if (goal.wanted) {
      why_none = std::move(why);
    }
  }
  return ready;
}

/// Describes a robot that has described itself and said where it stands.
Candidate Dispatcher::candidate_of(const Robot& robot) const {
  return {.robot = robot.id,
          .at = robot.state->place,
          .methods = methods_of(robot),
          .keeps_limits = robot.description->knows_limits,
          .percent = charge_that_counts(robot.id)};
}

/// Searches a way from a robot's place and, where there is none, from places beside it: from the last place of a run
/// nothing may lead on although its end lies on another run's way.
Result<Path> Dispatcher::way_of(const Candidate& from, const PlaceId& to, const ClosedHops* closed, SteadyTime now) {
  Result<Path> way = routes_.find_allowed(from.at, to, from.methods, from.keeps_limits, now, closed);
  if (way) return way;
  std::vector<PlaceId> beside = places_beside(context_.snapshots.current(), from.at);
  beside.resize(std::min(beside.size(), kStartsTried));
  for (const PlaceId& start : beside) {
    Result<Path> other = routes_.find_allowed(start, to, from.methods, from.keeps_limits, now, closed);
    if (other) return other;
  }
  return way;
}

/// Finds ways for goals of the server's own: over nothing that the robot has found blocked.
FindWay Dispatcher::ways_to(const PlaceId& to, Now now) {
  return [this, to, now](const Candidate& from) { return way_of(from, to, overlay_.closed(from.robot), now.steady); };
}

/// Finds ways over nothing that is closed for the goal. Where there is none but for that, says what is closed.
FindWay Dispatcher::ways_for(const Goal& goal, Now now) {
  if (goal.kind != GoalKind::operator_asked) return ways_to(goal.to, now);
  return [this, id = goal.id, to = goal.to, now](const Candidate& from) {
    const ClosedHops* const closed = overlay_.closed(id);
    Result<Path> way = way_of(from, to, closed, now.steady);
    if (way || closed == nullptr) return way;
    const Result<Path> if_open = way_of(from, to, nullptr, now.steady);
    if (!if_open) return Result<Path>(fail(if_open.error()));
    return Result<Path>(fail(ErrorCode::not_found, closed_text(id) + ", or a robot has driven it, and no other way "
                                                                     "leads there: it waits for that"));
  };
}

/// Returns the goals that nobody has yet, in the order in which they were accepted.
std::vector<const Goal*> Dispatcher::pending() const {
  std::vector<const Goal*> waiting;
  for (const auto& [number, id] : book_.alive()) {
    const Goal* const goal = book_.find(id);
    if (goal->state == GoalState::pending) waiting.push_back(goal);
  }
  return waiting;
}

/// Gives out goals. Returns false where searches for ways have to go on first: soon, between messages.
bool Dispatcher::assign_waiting(Now now) {
  const Revision revision = context_.snapshots.current().revision();
  if (tried_at_ != revision) {
    tried_.clear();
    choosing_.clear();
  }
  tried_at_ = revision;
  std::size_t left = kWaysAtOnce;
  bool is_done = true;
  Queues queues;
  std::vector<GoalId> turns;
  for (const Goal* const goal : turns_.in_turn(pending(), now.steady)) turns.push_back(goal->id);
  for (const GoalId& id : turns) {
    const Goal& goal = *book_.find(id);
    std::string why_none = "no robot is idle and knows where it is";
    const std::vector<Candidate> ready = candidates(goal, why_none);
    if (ready.empty()) {
      recall_from_parking(goal, now);
      still_pending(goal, Why::turn, why_none, queues);
      continue;
    }
    if (const std::string first = why_another_first(goal, ready, queues, now); !first.empty()) {
      still_pending(goal, Why::taken, first, queues);
      continue;
    }
    const auto tried = tried_.find(id);
    if (tried != tried_.end() && tried->second == ready) {
      queues.begun.insert(goal.wanted);
      continue;
    }
    Choosing& choosing = choosing_[id];
    const std::optional<Result<Choice>> choice = choosing.go_on(ready, ways_that_charge_covers(goal, now), left);
    if (!choice) {
      is_done = false;
      break;
    }
    if (!*choice) {
      own_goals_.fell_short = choosing.refused();
      note_fell_short(now);
      tried_[id] = ready;
      still_pending(goal, Why::no_way, choice->error().message, queues);
    }
    choosing_.erase(id);
    if (*choice && assign(goal, **choice, now)) forget_waiting(id);
  }
  note_pending(queues, now);
  return is_done;
}

/// Decides what a pending goal says. The first goal for a robot, or for any, says what it waits for whenever that
/// changes. Those behind it say once that it comes first, and once that there was no way: a queue writes as much as
/// it is long, not its square.
void Dispatcher::still_pending(const Goal& goal, Why kind, const std::string& why, Queues& queues) const {
  const bool is_first = queues.begun.insert(goal.wanted).second;
  const auto told = told_.find(goal.id);
  if (!is_first && told != told_.end() && told->second.contains(kind)) return;
  std::string text = why;
  if (!is_first && kind == Why::turn) {
    text = goal.wanted ? "goals for " + fleet_.name_of(*goal.wanted) + " that were asked for earlier come first"
                       : "goals that were asked for earlier come first";
  }
  queues.waiting.push_back({{goal.id, std::move(text)}, kind});
}

void Dispatcher::note_pending(const Queues& queues, Now now) {
  std::vector<GoalBook::Waiting> fresh;
  for (const Queues::Waits& waits : queues.waiting) {
    if (book_.find(waits.goal.goal)->history.back().cause != waits.goal.why) fresh.push_back(waits.goal);
  }
  // What cannot be kept now is tried again when it is looked at next.
  if (!book_.write(fresh, now)) return;
  for (const Queues::Waits& waits : queues.waiting) told_[waits.goal.goal].insert(waits.kind);
}

void Dispatcher::forget_waiting(const GoalId& goal) {
  tried_.erase(goal);
  choosing_.erase(goal);
  told_.erase(goal);
}

Route Dispatcher::route_of(const Goal& goal, const Choice& choice) {
  Route route;
  route.goal = goal.id;
  route.id = goal.route ? *goal.route : new_route_id();
  route.version = goal.route_version + 1;
  route.made_of = context_.snapshots.current().revision();
  route.robot = choice.robot;
  route.places = choice.path.places;
  route.relations = choice.path.relations;
  route.limits = limits_of(routes_.rules(), route.places);
  return route;
}

RouteId Dispatcher::new_route_id() {
  RouteId id;
  for (std::uint8_t& byte : id.bytes) byte = static_cast<std::uint8_t>(random_.next());
  return id;
}

bool Dispatcher::assign(const Goal& goal, const Choice& choice, Now now) {
  Goal next = goal;
  next.robot = choice.robot;
  const GoalBook::Step step = {.state = GoalState::assigned,
                               .cause = "to " + fleet_.name_of(choice.robot) + ", " + metres(choice.path.length_m) +
                                        " away by " + std::to_string(choice.path.places.size()) + " places",
                               .who = "dispatcher"};
  return give(next, step, choice, now);
}

/// Stores that the robot has the goal from now on, and its route.
bool Dispatcher::give(const Goal& goal, const GoalBook::Step& step, const Choice& choice, Now now) {
  if (!book_.write(goal, step, route_of(goal, choice), {}, now)) return false;
  RouteAssignment assignment;
  assignment.goal = goal.id;
  assignment.send_at = now.steady;
  assignment.plan_at = now.steady;
  assignment.given_at = now.steady;
  assignments_[choice.robot] = assignment;
  planning_.want();
  return true;
}

/// Notes once what the goal waits for.
void Dispatcher::wait_for(const Goal& goal, const std::string& why, Now now) {
  if (goal.history.back().cause == why) return;
  std::ignore = book_.write(goal, {.state = goal.state, .cause = why, .who = "dispatcher", .kind = "goal.waits"},
                            std::nullopt, {}, now);
}

/// Plans the same goal from where the robot stands, as the next version of the route that it has lost. What it held
/// stays held until the new version is released.
void Dispatcher::replan(const RobotId& robot, RouteAssignment& assignment, Now now) {
  const Robot* const known = fleet_.find(robot);
  const Goal& goal = *book_.find(assignment.goal);
  if (assignment.plan_at > now.steady || goal.state == GoalState::paused) return;
  if (known == nullptr || !unreachable_reason(*known).empty() || !known->state) return;
  if (goal.kind != GoalKind::operator_asked) {
    return finish(robot, assignment, GoalState::cancelled, "its route was lost; it is asked again if need be",
                  "traffic", now);
  }
  const msg::RobotState& state = *known->state;
  if (!state.localised || !state.place) {
    return wait_for(goal,
                    known->name + " does not know where it is: it looks for itself, and `weft localise " +
                        known->name + " --at LABEL` helps",
                    now);
  }
  assignment.plan_at = now.steady + kBetweenRoutePlans;
  if (context_.snapshots.current().place(state.place) == nullptr) {
    return wait_for(goal, known->name + " stands on a place that was taken out of the map: it looks for itself", now);
  }
  const Result<Choice> choice = choose({{.robot = robot,
                                         .at = state.place,
                                         .methods = methods_of(*known),
                                         .keeps_limits = known->description->knows_limits}},
                                       ways_for(goal, now));
  if (!choice) {
    if (!assignment.waits_since) assignment.waits_since = now;
    return wait_for(goal, choice.error().message, now);
  }
  const std::string round = closed_text(goal.id);
  const GoalBook::Step step = {.state = goal.state,
                               .cause = "planned anew for " + known->name + " from " + to_string(state.place) + ", " +
                                        metres(choice->path.length_m) + (round.empty() ? "" : "; " + round),
                               .who = "dispatcher",
                               .kind = "goal.planned_anew"};
  Route route = route_of(goal, *choice);
  if (assignment.is_closed) route.id = new_route_id();
  if (!book_.write(goal, step, route, {}, now)) return;
  assignment.find_again();
  assignment.cut_short = false;
  assignment.is_closed = false;
  assignment.noted_way = {};  // told anew, if it waits again
  assignment.noted_rule.clear();
  assignment.has_latest_order = false;
  assignment.latest_report.reset();
  assignment.at = 0;
  assignment.missing_since.reset();
  assignment.look_at_release = true;
  assignment.stands_at_end = false;
  assignment.waits_since.reset();
  planning_.want();
}

}  // namespace weft::server
