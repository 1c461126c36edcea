#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <utility>

#include "server/requests/operator_requests.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Bounds the wait for robots, which answer in milliseconds when they live; the operator hears by then how each
/// stands, with or without its answer.
constexpr Duration kAnswerWithin = 1500ms;
constexpr std::size_t kMostLines = 100;  ///< of a reply

std::string in_seconds(Duration duration) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", seconds(duration));
  return text.data();
}

}  // namespace

void OperatorRequests::stop_or_resume(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                      Now now) {
  std::vector<RobotId> robots;
  if (request.robot.empty()) {
    for (const auto& [id, robot] : fleet_.robots()) robots.push_back(id);
  } else {
    const Result<RobotId> id = fleet_.by_name(request.robot);
    if (!id) return answer(key, msg::Outcome::refused, id.error().message);
    robots.push_back(*id);
  }
  if (robots.empty()) return answer(key, msg::Outcome::done, "there is no robot");
  GroupCommand group;
  group.stops = request.kind == msg::OperatorRequest::Kind::stop;
  group.answer_by = now.steady + kAnswerWithin;
  for (const RobotId& id : robots) group.robots.push_back(command_in_group(key, *fleet_.find(id), request, who, now));
  const bool waits = std::any_of(group.robots.begin(), group.robots.end(),
                                 [](const GroupCommand::Robot& robot) { return robot.command.has_value(); });
  group_commands_[key] = std::move(group);
  if (!waits) answer_group(key, now.steady);
}

/// Pauses the robot's goal or lets it go on, and tells the robot. One that is not heard is told when it is; nobody
/// waits for its answer.
OperatorRequests::GroupCommand::Robot OperatorRequests::command_in_group(const Key& key, const Robot& robot,
                                                                         const msg::OperatorRequest& request,
                                                                         const std::string& who, Now now) {
  const bool stops = request.kind == msg::OperatorRequest::Kind::stop;
  GroupCommand::Robot one{.id = robot.id, .goal = {}, .command = {}, .has_confirmed = false, .refusal = {}};
  if (!stops && robot.incarnations.twins()) {
    one.refusal = unreachable_reason(robot);
    return one;
  }
  context_.writer.note({.at = {},
                        .kind = stops ? "robot.stop_asked" : "robot.resume_asked",
                        .robot = robot.id,
                        .goal = {},
                        .cause = request.robot.empty() ? "all robots" : "",
                        .who = who},
                       now);
  const Result<std::string> stored =
      stops ? dispatcher_.pause(robot.id, who, now) : dispatcher_.resume(robot.id, who, now);
  one.goal = stored ? *stored : "its goal's state could not be stored: " + stored.error().message;
  // To stand is more urgent than to write it down; to go on while the goal is paused would be undone at once.
  if (!stored && !stops) {
    one.refusal = std::exchange(one.goal, {}) + ": try again";
    return one;
  }
  if (stored) {
    unstored_stops_.erase(robot.id);
  } else {
    unstored_stops_[robot.id] = who;
  }
  msg::AgentCommand command;
  command.to = robot.id;
  command.kind = stops ? msg::AgentCommand::Kind::stop : msg::AgentCommand::Kind::resume;
  const std::uint64_t number = commands_.give(std::move(command), now.steady);
  if (robot.silent) return one;
  asked_for_[number] = key;
  one.command = number;
  return one;
}

void OperatorRequests::group_answered(const Key& key, std::uint64_t command, const msg::AgentReply& reply,
                                      SteadyTime now) {
  GroupCommand& group = group_commands_.at(key);
  bool all = true;
  for (GroupCommand::Robot& robot : group.robots) {
    if (robot.command == command) {
      robot.command.reset();
      robot.has_confirmed = reply.done;
      if (!reply.done) robot.refusal = "refused: " + reply.reason;
    }
    all = all && !robot.command;
  }
  if (all) answer_group(key, now);
}

void OperatorRequests::group_fell_silent(const Key& key, std::uint64_t command, SteadyTime now) {
  msg::AgentReply none;
  none.done = false;
  none.reason = "it fell silent before it answered; is its agent running?";
  group_answered(key, command, none, now);
}

void OperatorRequests::answer_overdue(SteadyTime now) {
  std::vector<Key> overdue;
  for (const auto& [key, group] : group_commands_) {
    if (group.answer_by <= now) overdue.push_back(key);
  }
  for (const Key& key : overdue) answer_group(key, now);
}

void OperatorRequests::answer_group(const Key& key, SteadyTime now) {
  const GroupCommand group = std::move(group_commands_.extract(key).mapped());
  // Whoever has not confirmed is what the operator has to know first.
  std::vector<std::string> open;
  std::vector<std::string> settled;
  for (const GroupCommand::Robot& robot : group.robots) {
    if (robot.command) asked_for_.erase(*robot.command);
    (robot.has_confirmed ? settled : open).push_back(line_of(group, robot, now));
  }
  msg::OperatorReply reply;
  reply.outcome = open.empty() ? msg::Outcome::done : msg::Outcome::failed;
  const std::size_t all = group.robots.size();
  if (all == 1) {
    reply.message = open.empty() ? settled.front() : open.front();
  } else {
    reply.message = std::to_string(settled.size()) + " of " + std::to_string(all) + " robots " +
                    (group.stops ? "stand" : "go on") +
                    (open.empty() ? "" : ", " + std::to_string(open.size()) + " not confirmed");
    reply.findings = std::move(open);
    reply.findings.insert(reply.findings.end(), settled.begin(), settled.end());
    reply.findings.resize(std::min(reply.findings.size(), kMostLines));
  }
  answer(key, std::move(reply));
}

std::string OperatorRequests::line_of(const GroupCommand& group, const GroupCommand::Robot& robot,
                                      SteadyTime now) const {
  const std::string name = fleet_.name_of(robot.id) + ": ";
  const std::string goal = robot.goal.empty() ? "" : "; " + robot.goal;
  if (robot.has_confirmed) return name + (group.stops ? "stands" : "goes on") + goal;
  if (!robot.refusal.empty()) return name + robot.refusal + goal;
  return name + "not heard for " + in_seconds(now - fleet_.find(robot.id)->heard) + "; it is told when it is heard" +
         (group.stops ? ", and until then drives " + reach_of(robot.id) : "") + goal;
}

/// Returns how far a robot may go that hears nothing.
std::string OperatorRequests::reach_of(const RobotId& robot) const {
  const Goal* const goal = dispatcher_.goal_of(robot);
  const Route* const route = goal == nullptr ? nullptr : dispatcher_.book().route(goal->id);
  if (route == nullptr || route->ended) return "nowhere, as nothing is released to it";
  return "no farther than place " + to_string(route->places[route->released]) + ", the end of what is released to it";
}

}  // namespace weft::server
