#include <utility>

#include "agents/agent/robot/robot_agent.hpp"
#include "agents/agent/teach_report.hpp"

namespace weft::agents {
namespace {

using Kind = msg::AgentCommand::Kind;

bool only_asks(Kind kind) {
  return kind == Kind::teach_report || kind == Kind::counts;
}

}  // namespace

void RobotAgent::on(const msg::AgentCommand& command, SteadyTime now) {
  if (!session_.is_meant_for_me(command.header, now)) return;
  const CommandKey key{command.header.epoch, command.command};
  if (!replies_.is_fresh(key)) return;
  if (!only_asks(command.kind)) teach_.forget_failure();
  switch (command.kind) {
    case Kind::teach_start:
      return teach_start(command, key, now);
    case Kind::teach_stop:
      return teach_.stop(key, now);
    case Kind::localise:
      return localise(command, key, now);
    case Kind::stop:
      return stop(key, now);
    case Kind::resume:
      return resume(key, now);
    case Kind::keep_place:
      return keep_place(command, key, now);
    case Kind::teach_report:
      return report_teaching(command, key);
    case Kind::counts:
      return report_counts(key);
  }
  replies_.refuse(key, "this agent does not know the command");
}

void RobotAgent::teach_start(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (!teach_.start(command, key, condition_, follow_.has_route(), now)) return;
  localise_.drop();
  if (command.seed.has_value() || map_.proposals().is_alone()) {
    map_.leave_proposals(command.seed, map_context(), now);
  }
}

void RobotAgent::keep_place(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (teach_.is_active()) return teach_.keep_place(key, now);
  keep_place_.start(command, key, condition_.lost, now);
}

void RobotAgent::localise(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (condition_.is_faulted()) return replies_.refuse(key, config_.name + " is out of order: " + condition_.fault);
  if (teach_.is_active()) return replies_.refuse(key, config_.name + " is being taught: stop that first");
  if (mode_of(standing()) == msg::RobotMode::driving) {
    return replies_.refuse(key, config_.name + " drives, and knows where it is: stop it or cancel its goal first");
  }
  localise_.start(key, command.seed, now);
  follow_.await_localisation(now);
  if (command.seed.has_value()) {
    map_.leave_proposals(command.seed, map_context(), now);
  } else {
    map_.look_anywhere(now);
  }
}

void RobotAgent::stop(const CommandKey& key, SteadyTime now) {
  condition_.stopped = true;
  navigator_->stop();
  follow_.stop("stopped by an operator", now);
  if (teach_.is_active()) outbox_.stop_hand();
  replies_.give(key, carried_out());
}

void RobotAgent::resume(const CommandKey& key, SteadyTime now) {
  if (!condition_.safety.resume()) return replies_.refuse(key, condition_.safety.reason(config_.name));
  if (condition_.stopped) follow_.resume(now);
  condition_.stopped = false;
  replies_.give(key, carried_out());
}

void RobotAgent::report_teaching(const msg::AgentCommand& command, const CommandKey& key) {
  Result<msg::AgentReply> report = teach_report(*navigator_, config_.name, command.name);
  if (!report) return replies_.refuse(key, report.error().message);
  replies_.give(key, std::move(*report));
}

void RobotAgent::report_counts(const CommandKey& key) {
  msg::AgentReply done = carried_out();
  for (const auto& [what, times] : counters()) done.counts.emplace_back(what, times);
  replies_.give(key, std::move(done));
}

}  // namespace weft::agents
