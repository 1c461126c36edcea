#include "server/requests/commands.hpp"

#include <algorithm>
#include <utility>

#include "server/base/repeating.hpp"

namespace weft::server {

std::uint64_t Commands::give(msg::AgentCommand command, SteadyTime now) {
  const RobotId robot = command.to;
  const std::uint64_t number = next_number_++;
  command.command = number;
  queues_[robot].push_back({.command = std::move(command), .send_at = now});
  tick(now);
  return number;
}

std::optional<msg::AgentCommand> Commands::on_reply(const msg::AgentReply& reply, SteadyTime now) {
  const auto queue = queues_.find(reply.header.sender);
  if (queue == queues_.end()) return std::nullopt;
  const auto found = std::find_if(queue->second.begin(), queue->second.end(),
                                  [&](const Waiting& waiting) { return waiting.command.command == reply.command; });
  if (found == queue->second.end()) return std::nullopt;
  msg::AgentCommand command = std::move(found->command);
  queue->second.erase(found);
  if (queue->second.empty()) queues_.erase(queue);
  tick(now);
  return command;
}

std::vector<msg::AgentCommand> Commands::give_up(const RobotId& robot) {
  std::vector<msg::AgentCommand> given_up;
  const auto queue = queues_.find(robot);
  if (queue == queues_.end()) return given_up;
  std::erase_if(queue->second, [&](const Waiting& waiting) {
    if (waiting.command.kind == msg::AgentCommand::Kind::stop) return false;
    given_up.push_back(waiting.command);
    return true;
  });
  if (queue->second.empty()) queues_.erase(queue);
  return given_up;
}

void Commands::tick(SteadyTime now) {
  for (auto& [robot, queue] : queues_) {
    for (std::size_t i = 0; i < queue.size(); ++i) {
      Waiting& waiting = queue[i];
      if (!may_go(queue, i) || waiting.send_at > now) continue;
      waiting.wait = next_wait(waiting.wait);
      waiting.send_at = now + waiting.wait;
      context_.out.send(waiting.command);
    }
  }
}

std::optional<SteadyTime> Commands::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [robot, queue] : queues_) {
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (may_go(queue, i) && (!next || queue[i].send_at < *next)) next = queue[i].send_at;
    }
  }
  return next;
}

}  // namespace weft::server
