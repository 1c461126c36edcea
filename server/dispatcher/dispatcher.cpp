#include "server/dispatcher/dispatcher.hpp"

#include <algorithm>
#include <utility>

#include "core/network/way_on.hpp"

namespace weft::server {
namespace {

msg::OperatorReply reply(msg::Outcome outcome, const GoalId& goal, const std::string& message) {
  msg::OperatorReply answer;
  answer.outcome = outcome;
  answer.goal = goal;
  answer.message = message;
  return answer;
}

msg::OperatorReply state_reply(const Goal& goal) {
  const bool is_rejected = goal.state == GoalState::rejected;
  return reply(is_rejected ? msg::Outcome::refused : msg::Outcome::accepted, goal.id,
               std::string(to_string(goal.state)) + ": " + goal.history.back().cause);
}

std::string known_labels(const Snapshot& snapshot) {
  if (snapshot.labels().empty()) return "; the map has no label yet: weft map label";
  std::string text = "; known:";
  std::size_t listed = 0;
  for (const auto& [label, place] : snapshot.labels()) {
    text += " " + label;
    if (++listed == 10) break;
  }
  return text;
}

}  // namespace

Dispatcher::Dispatcher(Context& context, Fleet& fleet, Traffic& traffic, Routes& routes, Arrivals& arrivals,
                       Random random, std::map<GoalId, Goal> goals, std::map<GoalId, Route> given, SteadyTime now)
    : context_(context),
      fleet_(fleet),
      traffic_(traffic),
      routes_(routes),
      arrivals_(arrivals),
      random_(random),
      book_(context, std::move(goals), std::move(given)),
      planning_(traffic.proximity()),
      own_goals_(context.config.charge),
      look_at_(now) {
  for (const auto& [id, goal] : book_.goals()) {
    const Route* const route = book_.route(id);
    if (!goal.robot || route == nullptr) continue;
    const bool is_over = is_terminal(goal.state);
    // Over, and what it held is still held: the robot may not know yet.
    if (is_over && !is_told(*goal.robot, *route)) continue;
    RouteAssignment assignment;
    assignment.goal = id;
    if (is_over) assignment.standing = RouteAssignment::Standing::over;
    assignment.send_at = now;
    assignment.plan_at = now;
    assignment.given_at = now;
    if (is_over) assignment.ordered_at = now;
    // Prefers the goal that is not over: while nothing of that is released, the robot holds what it had for the one
    // before.
    const auto [known, is_new] = assignments_.try_emplace(*goal.robot, assignment);
    if (!is_new && !is_over) known->second = assignment;
  }
}

const Goal* Dispatcher::goal_of(const RobotId& robot) const {
  const auto found = assignments_.find(robot);
  return found == assignments_.end() ? nullptr : book_.find(found->second.goal);
}

msg::OperatorReply Dispatcher::send(const msg::OperatorRequest& request, const std::string& who, Now now) {
  if (!request.goal) {
    return reply(msg::Outcome::refused, {}, "a goal needs an id, drawn at random by who asks for it");
  }
  if (const Goal* const known = book_.find(request.goal)) {
    if (known->label == request.label) return state_reply(*known);
    return reply(msg::Outcome::refused, request.goal,
                 "goal " + to_string(request.goal) + " exists and goes to " + known->label + ": draw another id");
  }
  Goal goal;
  goal.id = request.goal;
  goal.label = request.label;
  goal.number = book_.next_number();
  goal.priority = request.priority;
  goal.no_return = request.no_return;
  GoalBook::Step step = {.state = GoalState::pending, .cause = "asked for", .who = who};
  const Snapshot& snapshot = context_.snapshots.current();
  const auto label = snapshot.labels().find(request.label);
  if (request.place && request.on_plan) {
    goal.to = request.place;
    goal.priority = std::max(goal.priority, routes_.rules().priority(goal.to));
  } else if (label == snapshot.labels().end()) {
    step.state = GoalState::rejected;
    step.cause = "the map has no label " + request.label + known_labels(snapshot);
  } else {
    goal.to = label->second;
    goal.priority = std::max(goal.priority, routes_.rules().priority(goal.to));
  }
  if (step.state == GoalState::pending && !request.robot.empty()) {
    const Result<RobotId> wanted = fleet_.by_name(request.robot);
    if (wanted) {
      goal.wanted = *wanted;
    } else {
      step.state = GoalState::rejected;
      step.cause = wanted.error().message;
    }
  }
  if (std::string why = step.state == GoalState::pending ? no_return(goal) : std::string(); !why.empty()) {
    step.state = GoalState::rejected;
    step.cause = std::move(why);
  }
  const GoalId id = goal.id;
  if (const Result<void> stored = book_.write(std::move(goal), step, std::nullopt, {}, now); !stored) {
    return reply(msg::Outcome::refused, id, "the goal could not be stored: " + stored.error().message);
  }
  look_again_ = true;
  look_at_ = now.steady;
  return state_reply(*book_.find(id));
}

/// Says why a robot that has come to the goal could not leave again; empty: it could, or that is wanted.
std::string Dispatcher::no_return(const Goal& goal) const {
  if (goal.no_return) return {};
  const Robot* const wanted = goal.wanted ? fleet_.find(*goal.wanted) : nullptr;
  const Snapshot& network = context_.snapshots.current();
  const bool is_described = wanted != nullptr && wanted->description;
  const std::string why = no_way_on(network, goal.to, is_described ? methods_of(*wanted) : methods_in(network));
  if (why.empty()) return {};
  return "a robot could not leave " + goal.label + " again: " + why +
         ", or send it all the same with --no-return and fetch it by hand";
}

msg::OperatorReply Dispatcher::cancel(const GoalId& id, const std::string& who, Now now) {
  const Goal* const goal = book_.find(id);
  if (goal == nullptr) {
    return reply(msg::Outcome::refused, id, "there is no goal " + to_string(id) + ": weft goal list");
  }
  if (goal->state == GoalState::cancelled) return reply(msg::Outcome::done, id, "it is cancelled");
  if (is_terminal(goal->state)) {
    return reply(msg::Outcome::refused, id, std::string("it is over already: ") + to_string(goal->state));
  }
  const std::string cause = "cancelled";
  const auto assignment = goal->robot ? assignments_.find(*goal->robot) : assignments_.end();
  if (assignment != assignments_.end() && assignment->second.goal == id) {
    finish(assignment->first, assignment->second, GoalState::cancelled, cause, who, now);
  } else {
    const GoalBook::Step step = {.state = GoalState::cancelled, .cause = cause, .who = who};
    // Seen below: the state changes only once it is stored.
    std::ignore = book_.write(*goal, step, std::nullopt, {}, now);
  }
  if (book_.find(id)->state != GoalState::cancelled) {
    return reply(msg::Outcome::failed, id, "the store takes nothing at the moment: try again");
  }
  forget_waiting(id);
  return reply(msg::Outcome::done, id, "cancelled");
}

Result<std::string> Dispatcher::pause(const RobotId& robot, const std::string& who, Now now) {
  const Goal* const goal = goal_of(robot);
  if (goal == nullptr || is_terminal(goal->state)) return std::string("it has no goal");
  if (goal->state == GoalState::paused) return "its goal " + to_string(goal->id) + " is paused";
  const GoalBook::Step step = {.state = GoalState::paused, .cause = "its robot is told to stop", .who = who};
  if (const Result<void> stored = book_.write(*goal, step, std::nullopt, {}, now); !stored) {
    return fail(stored.error());
  }
  return "its goal " + to_string(goal->id) + " is paused";
}

Result<std::string> Dispatcher::resume(const RobotId& robot, const std::string& who, Now now) {
  const auto assignment = assignments_.find(robot);
  const Goal* const goal = goal_of(robot);
  if (goal == nullptr || goal->state != GoalState::paused) return std::string("it has no paused goal");
  const bool was_executing = std::any_of(goal->history.begin(), goal->history.end(),
                                         [](const GoalEvent& event) { return event.state == GoalState::executing; });
  const GoalBook::Step step = {.state = was_executing ? GoalState::executing : GoalState::assigned,
                               .cause = "its robot is told to go on",
                               .who = who};
  if (const Result<void> stored = book_.write(*goal, step, std::nullopt, {}, now); !stored) {
    return fail(stored.error());
  }
  assignment->second.send_at = now.steady;
  assignment->second.look_at_release = true;
  return "its goal " + to_string(goal->id) + " goes on";
}

/// Ends the robot's goal when it is not over yet; what the robot holds is left to the caller.
Result<void> Dispatcher::fail_goal(const RobotId& robot, const std::string& cause, const std::string& who, Now now) {
  const auto assignment = assignments_.find(robot);
  if (assignment == assignments_.end() || assignment->second.is_over()) return {};
  finish(robot, assignment->second, GoalState::failed, cause, who, now);
  const auto still = assignments_.find(robot);
  if (still == assignments_.end() || still->second.is_over()) return {};
  return fail(ErrorCode::unavailable, "the store takes nothing at the moment: try again");
}

void Dispatcher::fail_waiting_for(const RobotId& robot, const std::string& why, const std::string& who, Now now) {
  const std::map<std::uint64_t, GoalId> alive = book_.alive();
  for (const auto& [number, id] : alive) {
    const Goal& goal = *book_.find(id);
    if (goal.state != GoalState::pending || goal.wanted != robot) continue;
    const GoalBook::Step step = {.state = GoalState::failed, .cause = why, .who = who};
    if (book_.write(goal, step, std::nullopt, {}, now)) forget_waiting(id);
  }
}

/// Tells the robot to end its route, again and again until it has; meanwhile the place is held where it says that it
/// is.
Result<std::string> Dispatcher::clear_heard(const Robot& robot, const std::string& who, Now now) {
  if (const Result<void> over = fail_goal(robot.id, "its robot was cleared off its route", who, now); !over) {
    return fail(over.error());
  }
  look_again_ = true;
  const bool knows = robot.state && robot.state->localised && robot.state->place;
  return traffic_.clear_route(robot.id, knows ? std::optional(robot.state->place) : std::nullopt, who, now);
}

Result<std::string> Dispatcher::clear(const RobotId& robot, bool is_sure, const std::string& who, Now now) {
  const Robot* const known = fleet_.find(robot);
  const bool is_heard = known != nullptr && !known->silent;
  if (is_heard && is_sure) return clear_heard(*known, who, now);
  if (is_heard) {
    return fail(ErrorCode::refused, known->name +
                                        " is heard, so it stands where it says: take it off the floor and "
                                        "end its agent before it is cleared; `weft robot clear " +
                                        known->name + " --yes` frees its route alone, and fails its goal");
  }
  if (const Result<void> over = fail_goal(robot, "its robot was cleared away", who, now); !over) {
    return fail(over.error());
  }
  assignments_.erase(robot);
  look_again_ = true;
  planning_.want();
  return traffic_.clear(robot, who, now);
}

}  // namespace weft::server
