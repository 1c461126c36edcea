#include <algorithm>
#include <chrono>
#include <optional>

#include "clients/cli/commands.hpp"
#include "clients/cli/table.hpp"
#include "clients/cli/wait_chain.hpp"
#include "core/text.hpp"

namespace weft::cli {
namespace {
using namespace std::chrono_literals;
using Command = Invocation::Command;

constexpr Duration kBetweenLooks = 500ms;
constexpr Duration kLook = 5s;

/// Holds the goals as they are, with names for their robots.
struct Goals {
  std::vector<Goal> goals;
  std::vector<Route> routes;
  std::vector<msg::Arrival> arrivals;
  std::vector<msg::RobotRow> robots;
  Names names;
  WallTime seen_at{};

  const Route* route(const GoalId& id) const {
    const auto found =
        std::find_if(routes.begin(), routes.end(), [&](const Route& route) { return route.goal == id; });
    return found == routes.end() ? nullptr : &*found;
  }
  const msg::Arrival* arrival(const GoalId& id) const {
    const auto found =
        std::find_if(arrivals.begin(), arrivals.end(), [&](const msg::Arrival& one) { return one.goal == id; });
    return found == arrivals.end() ? nullptr : &*found;
  }
  nlohmann::json document(const Goal& goal) const {
    const Route* const way = route(goal.id);
    nlohmann::json object = to_json(goal, way, names, seen_at);
    const msg::Arrival* const foretold = arrival(goal.id);
    object["arrival"] = foretold != nullptr ? to_json(*foretold) : nlohmann::json();
    object["route_at"] = nlohmann::json();
    for (const msg::RobotRow& row : robots) {
      if (way == nullptr || row.state.goal != goal.id) continue;
      const auto at = std::find(way->places.begin(), way->places.end(), row.state.place);
      if (at != way->places.end()) object["route_at"] = at - way->places.begin();
    }
    return object;
  }
};

Result<Goals> look(Session& session, const GoalId& only, Duration at_most) {
  Result<msg::QueryReply> robots = query_robots(session, at_most);
  if (!robots) return fail(robots.error());
  msg::Query query;
  query.kind = msg::Query::Kind::goals;
  query.goal = only;
  Result<msg::QueryReply> goals = session.query(query, at_most);
  if (!goals) return fail(goals.error());
  return Goals{std::move(goals->goals), std::move(goals->routes), std::move(goals->arrivals),
               robots->robots,          names_of(robots->robots), session.world().wall()};
}

/// Returns the goal whose id begins so. not_found: no goal does, or more than one.
Result<Goal> find(const Goals& goals, const std::string& beginning) {
  const Goal* found = nullptr;
  for (const Goal& goal : goals.goals) {
    if (!to_string(goal.id).starts_with(beginning)) continue;
    if (found != nullptr) {
      return fail(ErrorCode::not_found, "more than one goal begins with " + beginning + ": give more digits of it");
    }
    found = &goal;
  }
  if (found == nullptr) return fail(ErrorCode::not_found, "no goal " + beginning + ": see `weft goal list`");
  return *found;
}

std::string line(const GoalEvent& event) {
  return iso_time(event.at) + "  " + to_string(event.state) + (event.cause.empty() ? "" : ": " + event.cause) +
         (event.who.empty() ? "" : "  (" + event.who + ")");
}

Exit send(Session& session, const Invocation& invocation, const Output& output) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::goal_send;
  request.label = invocation.name;
  request.robot = invocation.robot;
  request.priority = static_cast<std::uint8_t>(invocation.priority);
  request.no_return = invocation.no_return;
  if (invocation.to_plan) request.on_plan = msg::PointOnPlan{invocation.plan, *invocation.to_plan};
  request.goal = session.new_goal();
  const GoalId id = request.goal;
  Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (exit_of(reply->outcome) == Exit::done) {
    reply->goal = id;
    reply->message = "goal " + to_string(id) + ": " + reply->message;
  }
  return show(*reply, invocation, output);
}

Exit list(const Goals& goals, const Invocation& invocation, const Output& output) {
  if (invocation.json) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Goal& goal : goals.goals) rows.push_back(goals.document(goal));
    output.out << printed(nlohmann::json{{"goals", std::move(rows)}}) << '\n';
    return Exit::done;
  }
  if (goals.goals.empty()) output.out << "no goals; send one: weft goal send --to LABEL\n";
  Table table;
  if (!goals.goals.empty()) table.add({"GOAL", "TO", "ROBOT", "STATE", "SECONDS", "ARRIVES IN", "CAUSE"});
  for (const Goal& goal : goals.goals) {
    const msg::Arrival* const arrival = goals.arrival(goal.id);
    table.add({to_string(goal.id).substr(0, 8), goal.label,
               goal.robot.has_value() ? name_of(goals.names, *goal.robot) : "-", to_string(goal.state),
               fixed(duration_s(goal, goals.seen_at), 1), arrival != nullptr ? minutes_text(arrival->in_s) : "-",
               goal.history.empty() ? "" : goal.history.back().cause});
  }
  table.print(output.out);
  return Exit::done;
}

Exit show_one(const Goal& goal, const Goals& goals, const Invocation& invocation, const Output& output) {
  const Route* const route = goals.route(goal.id);
  if (invocation.json) {
    output.out << printed(goals.document(goal)) << '\n';
    return Exit::done;
  }
  output.out << "goal " << to_string(goal.id) << " to " << goal.label << " (" << to_string(goal.to)
             << "): " << to_string(goal.state) << '\n';
  if (goal.priority > 0) output.out << "priority " << int{goal.priority} << '\n';
  if (goal.robot.has_value()) output.out << "robot " << name_of(goals.names, *goal.robot) << '\n';
  if (route != nullptr) {
    output.out << "route version " << route->version << ", " << route->places.size() << " places, released through "
               << route->released << (route->reason.empty() ? "" : ": " + route->reason) << '\n';
  }
  if (const msg::Arrival* const arrival = goals.arrival(goal.id)) output.out << to_text(*arrival) << '\n';
  for (const GoalEvent& event : goal.history) output.out << line(event) << '\n';
  return Exit::done;
}

/// Tells one event of a watched goal; with --json as a document of one line.
void tell(const Goal& goal, const GoalEvent& event, const Invocation& invocation, const Output& output) {
  if (invocation.json) {
    nlohmann::json document = to_json(event);
    document["goal"] = to_string(goal.id);
    output.out << printed(document, -1) << std::endl;
  } else {
    output.out << line(event) << std::endl;
  }
}

Exit watch(Session& session, const Goal& goal, const Invocation& invocation, const Output& output) {
  const SteadyTime end = session.world().now() + patience(invocation);
  std::size_t shown = 0;
  bool silent = false;
  while (session.world().now() < end) {
    const Result<Goals> goals = look(session, goal.id, kLook);
    if (!goals && !silent) output.err << "weft: the server is silent; still watching\n";
    silent = !goals;
    if (goals && !goals->goals.empty()) {
      const Goal& now = goals->goals.front();
      for (; shown < now.history.size(); ++shown) tell(now, now.history[shown], invocation, output);
      if (is_terminal(now.state)) {
        return now.state == GoalState::succeeded ? Exit::done : Exit::failed;
      }
    }
    session.world().wait(kBetweenLooks);
  }
  return report({ErrorCode::timed_out, "the goal is still under way: `weft goal why " +
                                           to_string(goal.id).substr(0, 8) + "` says what holds it up"},
                invocation.json, output);
}

/// Asks for what needs the goal's id alone.
Exit ask_of(Session& session, const Goal& goal, msg::OperatorRequest::Kind kind, const Invocation& invocation,
            const Output& output) {
  msg::OperatorRequest request;
  request.kind = kind;
  request.goal = goal.id;
  const Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  return show(*reply, invocation, output);
}

std::string standing(const msg::RobotRow& row) {
  std::string text = row.description.name + " is " + (row.is_heard ? msg::to_string(row.state.mode) : "silent");
  if (!row.is_heard) {
    text += ": not heard for " + fixed(row.silent_s, 0) + " s; its last word was " + msg::to_string(row.state.mode);
  }
  if (!row.state.reason.empty()) text += ": " + row.state.reason;
  if (!row.state.localised) text += "; it does not know where it is";
  if (!row.occupies.empty()) text += "; it occupies " + row.occupies;
  return text;
}

/// Shows what is known about a goal or a robot, newest last: its own history, the robot's word, and the events.
Exit why(Session& session, const Goals& goals, const Invocation& invocation, const Output& output) {
  const auto robot = std::find_if(goals.robots.begin(), goals.robots.end(), [&](const msg::RobotRow& row) {
    return row.description.name == invocation.goal || to_string(row.description.header.sender) == invocation.goal;
  });
  std::optional<Goal> goal;
  if (robot == goals.robots.end()) {
    const Result<Goal> found = find(goals, invocation.goal);
    if (!found) return report(found.error(), invocation.json, output);
    goal = *found;
  }
  msg::Query query;
  query.kind = msg::Query::Kind::events;
  if (goal.has_value()) {
    query.goal = goal->id;
  } else {
    query.robot = invocation.goal;
  }
  const Result<msg::QueryReply> events = session.query(query, patience(invocation));
  if (!events) return report(events.error(), invocation.json, output);
  const RobotId who =
      goal.has_value() ? goal->robot.value_or(goal->wanted.value_or(RobotId{})) : robot->description.header.sender;
  const auto row = std::find_if(goals.robots.begin(), goals.robots.end(),
                                [&](const msg::RobotRow& one) { return one.description.header.sender == who; });
  const Route* const route = goal.has_value() ? goals.route(goal->id) : nullptr;
  if (invocation.json) {
    nlohmann::json document = {{"events", nlohmann::json::array()}};
    for (const msg::Event& event : events->events) document["events"].push_back(to_json(event, goals.names));
    if (goal.has_value()) document["goal"] = goals.document(*goal);
    if (row != goals.robots.end()) document["robot"] = to_json(*row, goals.names);
    document["waits"] = chain_json(goals.robots, who);
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  for (const msg::Event& event : events->events) {
    output.out << iso_time(event.at) << "  " << event.kind << (event.cause.empty() ? "" : ": " + event.cause)
               << (event.who.empty() ? "" : "  (" + event.who + ")") << '\n';
  }
  if (goal.has_value()) {
    output.out << "goal " << to_string(goal->id).substr(0, 8) << " to " << goal->label << " is "
               << to_string(goal->state)
               << (goal->history.empty() || goal->history.back().cause.empty() ? ""
                                                                               : ": " + goal->history.back().cause)
               << '\n';
  }
  const msg::Arrival* const arrival = goal.has_value() ? goals.arrival(goal->id) : nullptr;
  if (arrival != nullptr) output.out << to_text(*arrival) << '\n';
  const bool waits = goal.has_value() && !is_terminal(goal->state) && route != nullptr && !route->reason.empty();
  if (waits) output.out << "its route waits: " << route->reason << '\n';
  if (row == goals.robots.end()) return Exit::done;
  output.out << standing(*row) << '\n' << chain_text(goals.robots, who, goals.seen_at);
  if (!row->standstill.empty()) output.out << "standstill: " << row->standstill << '\n';
  return Exit::done;
}

}  // namespace

Exit run_goals(Session& session, const Invocation& invocation, const Output& output) {
  if (invocation.command == Command::goal_send) return send(session, invocation, output);
  const Result<Goals> goals = look(session, GoalId{}, std::min<Duration>(patience(invocation), 60s));
  if (!goals) return report(goals.error(), invocation.json, output);
  if (invocation.command == Command::goal_list) return list(*goals, invocation, output);
  if (invocation.command == Command::goal_why) return why(session, *goals, invocation, output);
  const Result<Goal> goal = find(*goals, invocation.goal);
  if (!goal) return report(goal.error(), invocation.json, output);
  if (invocation.command == Command::goal_watch) return watch(session, *goal, invocation, output);
  using Kind = msg::OperatorRequest::Kind;
  if (invocation.command == Command::goal_cancel)
    return ask_of(session, *goal, Kind::goal_cancel, invocation, output);
  if (invocation.command == Command::goal_hand_over) {
    return ask_of(session, *goal, Kind::goal_hand_over, invocation, output);
  }
  return show_one(*goal, *goals, invocation, output);
}

}  // namespace weft::cli
