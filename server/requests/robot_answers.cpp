#include <utility>

#include "core/network/way_on.hpp"
#include "server/requests/operator_requests.hpp"

namespace weft::server {

void OperatorRequests::on_reply(const msg::AgentReply& reply, Now now) {
  const std::optional<msg::AgentCommand> command = commands_.on_reply(reply, now.steady);
  if (!command) return;
  answered_[command->to] = reply.header;
  robot_answered(*command, reply, now);
}

/// Returns whether the robot said that before it answered its last command, or has not answered that yet.
bool OperatorRequests::is_said_before_answer(const msg::RobotState& state) const {
  if (commands_.is_busy(state.header.sender)) return true;
  const auto answered = answered_.find(state.header.sender);
  return answered != answered_.end() && answered->second.incarnation == state.header.incarnation &&
         state.header.sequence < answered->second.sequence;
}

void OperatorRequests::robot_answered(const msg::AgentCommand& command, const msg::AgentReply& reply, Now now) {
  const auto asked = asked_for_.find(command.command);
  if (asked == asked_for_.end()) return;
  const Key key = asked->second;
  asked_for_.erase(asked);
  if (group_commands_.contains(key)) return group_answered(key, command.command, reply, now.steady);
  const auto found = waiting_.find(key);
  if (found == waiting_.end()) return;
  Waiting& waiting = found->second;
  waiting.commands.erase(command.command);
  const std::string robot = fleet_.name_of(command.to);
  if (!reply.done) {
    waiting.failed = true;
    waiting.message += (waiting.message.empty() ? "" : "; ") + robot + " refused: " + reply.reason;
  } else if (!reply.reason.empty()) {
    waiting.message += (waiting.message.empty() ? "" : "; ") + robot + ": " + reply.reason;
  }
  if (!waiting.commands.empty()) return;
  const Waiting done = std::move(waiting);
  waiting_.erase(found);
  if (command.kind == msg::AgentCommand::Kind::keep_place && reply.done) {
    label_kept_place({.label = command.name,
                      .place = reply.place,
                      .robot = command.to,
                      .asker = key.first,
                      .request = key.second,
                      .who = std::exchange(asked_by_[key], {})},
                     now);
    asked_by_.erase(key);
    return;
  }
  asked_by_.erase(key);
  msg::OperatorReply answered;
  answered.outcome = done.failed ? msg::Outcome::refused : msg::Outcome::done;
  answered.message = done.message.empty() ? robot + " has done it" : done.message;
  answered.place = reply.place;
  answered.experience = reply.experience;
  answered.report = reply.report;
  answered.counts = reply.counts;
  if (command.kind == msg::AgentCommand::Kind::teach_stop) answered.message += what_the_end_lacks(reply.experience);
  answer(key, std::move(answered));
}

/// Says that nothing leads on from the end of a run that is here as a whole; empty: something does, or it is not
/// here.
std::string OperatorRequests::what_the_end_lacks(const ExperienceId& run) const {
  const Snapshot& network = context_.snapshots.current();
  const auto found = network.experiences().find(run);
  if (found == network.experiences().end() || !found->second->sealed || found->second->places.empty()) return {};
  const PlaceId end{run, (found->second->places.end() - 1)->id.index};
  const std::string why = no_way_on(network, end, methods_in(network));
  return why.empty() ? std::string() : "; from its end, " + to_string(end) + ": " + why;
}

void OperatorRequests::on_state(const Robot& robot, Now now) {
  if (const auto stop = unstored_stops_.find(robot.id); stop != unstored_stops_.end()) {
    // Not to be taken for a robot that has missed its order to go on.
    if (!dispatcher_.pause(robot.id, stop->second, now)) return;
    unstored_stops_.erase(stop);
  }
  // A person has to let it go on: its goal waits for that.
  if (robot.state->safety == Safety::emergency_stop && !is_said_before_answer(*robot.state)) {
    std::ignore = dispatcher_.pause(robot.id, robot.name + "'s emergency stop", now);
  }
  const Goal* const goal = dispatcher_.goal_of(robot.id);
  if (goal == nullptr || commands_.is_busy(robot.id) || is_stop(robot.state->safety)) return;
  const msg::RobotMode mode = robot.state->mode;
  const bool drives = mode == msg::RobotMode::driving || mode == msg::RobotMode::waiting;
  const bool is_to_stop = goal->state == GoalState::paused && drives;
  const bool is_to_go = goal->state == GoalState::executing && mode == msg::RobotMode::stopped;
  if (!is_to_stop && !is_to_go) return;
  msg::AgentCommand command;
  command.to = robot.id;
  command.kind = is_to_stop ? msg::AgentCommand::Kind::stop : msg::AgentCommand::Kind::resume;
  commands_.give(std::move(command), now.steady);
}

void OperatorRequests::on_silence(const RobotId& robot, SteadyTime now) {
  for (const msg::AgentCommand& command : commands_.give_up(robot)) {
    const auto asked = asked_for_.find(command.command);
    if (asked == asked_for_.end()) continue;
    const Key key = asked->second;
    asked_for_.erase(asked);
    if (group_commands_.contains(key)) group_fell_silent(key, command.command, now);
    if (waiting_.erase(key) == 0) continue;
    asked_by_.erase(key);
    answer(key, msg::Outcome::failed,
           fleet_.name_of(robot) + " fell silent before it answered; is its agent running?");
  }
}

void OperatorRequests::on_twins(const RobotId& robot, Now now) {
  // Told to stand in any case; the goal shows it as soon as it can be stored.
  std::ignore = dispatcher_.pause(robot, "server", now);
  msg::AgentCommand command;
  command.to = robot;
  command.kind = msg::AgentCommand::Kind::stop;
  commands_.give(std::move(command), now.steady);
}

}  // namespace weft::server
