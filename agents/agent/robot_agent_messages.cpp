#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "agents/agent/surroundings.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kMapOfRouteAtMost = 20s;

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

}  // namespace

AgentOutput RobotAgent::handle(const msg::Message& message, SteadyTime now, WallTime wall) {
  const auto addressed = [&](const auto& m) {
    if (admit(m.header, m.to, now)) on(m, now);
  };
  std::visit(
      Overloaded{[&](const msg::Hello& m) { on(m, now); }, [&](const msg::BatchAck& m) { addressed(m); },
                 [&](const msg::Chunk& m) { addressed(m); }, [&](const msg::ContentRequest& m) { addressed(m); },
                 [&](const msg::WindowPatch& m) { addressed(m); }, [&](const msg::RouteOrder& m) { addressed(m); },
                 [&](const msg::AgentCommand& m) { addressed(m); }, [&](const msg::Recognised& m) { addressed(m); },
                 [&](const msg::ClockProbe& m) {
                   if (admit(m.header, m.to, now)) answer(m, now, wall);
                 },
                 [](const auto&) {}},
      message);
  return finish(now);
}

bool RobotAgent::admit(const msg::Header& header, const PeerId& to, SteadyTime now) {
  if (to != config_.self) return false;
  const Session::Heard heard_now = session_.hear(header, now);
  heard(heard_now, now);
  return heard_now != Session::Heard::refused;
}

void RobotAgent::heard(Session::Heard heard, SteadyTime now) {
  if (heard != Session::Heard::restarted) return;
  output_.notes.push_back("server: epoch " + std::to_string(session_.epoch().value));
  spooler_.server_restarted(now);
  replica_.server_restarted(now);
  cache_.server_restarted(now);
  recogniser_.server_restarted(now);
  task_.server_restarted(now);
  describe_at_ = now;
  state_at_ = now;
}

void RobotAgent::on(const msg::Hello& hello, SteadyTime now) {
  if (hello.role == msg::Role::server) heard(session_.hear(hello, now), now);
}

void RobotAgent::on(const msg::BatchAck& ack, SteadyTime now) {
  const Spooler::Heard heard = spooler_.on_ack(ack, now);
  output_.acks.insert(output_.acks.end(), heard.acknowledged.begin(), heard.acknowledged.end());
  if (!heard.reason.empty()) output_.notes.push_back(heard.reason);
  if (heard.refused) abandon_teaching(heard.reason, now);
  const bool of_what_was_taught = !heard.reason.empty() && !heard.lessons;
  if (of_what_was_taught && !heard.refused) navigator_->forget_taught(replica_.window());
  if (!heard.reason.empty() && handing_in_.has_value() && handing_in_->has(ack.experience)) {
    refuse(handing_in_->asked_by, heard.reason);
    handing_in_.reset();
  }
}

void RobotAgent::on(const msg::Chunk& chunk, SteadyTime now) {
  if (chunk.kind == msg::ContentKind::content) cache_.on_chunk(chunk, now);
}

void RobotAgent::on(const msg::ContentRequest& request, SteadyTime now) {
  spooler_.on_request(request, now);
}

void RobotAgent::on(const msg::WindowPatch& patch, SteadyTime now) {
  if (replica_.is_own(patch)) session_.answered(patch.header);
  if (replica_.on_patch(patch, now) != Replica::Heard::changed) return;
  keep_ground(now);
  want_contents(now);
}

void RobotAgent::on(const msg::RouteOrder& order, SteadyTime now) {
  if (!session_.is_meant_for_me(order.header, now)) return;
  const Route& route = order.route;
  if (teaching_.has_value() && !route.ended) return;  // The server learns from our state that we are being taught.
  const bool same_route = task_.route().has_value() && task_.route()->id == route.id;
  switch (task_.take(route, now)) {
    case RouteTask::Took::ignored:
      return;
    case RouteTask::Took::ended:
      navigator_->stop();
      command_ = Twist{};
      follow_pending_ = false;
      state_at_ = now;
      break;
    case RouteTask::Took::renewed:
      if (same_route && !follow_pending_ && !stopped_) {
        navigator_->follow(*task_.route());
        break;
      }
      if (!follow_pending_) navigator_->stop();
      follow_pending_ = true;
      follow_at_latest_ = now + kMapOfRouteAtMost;
      break;
    case RouteTask::Took::extended:
      if (!follow_pending_ && !stopped_) navigator_->follow(*task_.route());
      return;
  }
  WindowDefinition definition = replica_.definition();
  definition.route = always_held();
  replica_.define(std::move(definition), now);
}

void RobotAgent::on(const msg::AgentCommand& command, SteadyTime now) {
  if (!session_.is_meant_for_me(command.header, now)) return;
  const CommandKey key{command.header.epoch, command.command};
  switch (ledger_.see(key)) {
    case CommandLedger::Seen::under_way:
      return;
    case CommandLedger::Seen::answered:
      send(*ledger_.answer(key));
      return;
    case CommandLedger::Seen::fresh:
      break;
  }
  const bool only_asks =
      command.kind == msg::AgentCommand::Kind::teach_report || command.kind == msg::AgentCommand::Kind::counts;
  if (!only_asks) teaching_failed_.clear();
  switch (command.kind) {
    case msg::AgentCommand::Kind::teach_start:
      return teach_start(command, key, now);
    case msg::AgentCommand::Kind::teach_stop:
      return teach_stop(key, now);
    case msg::AgentCommand::Kind::localise:
      return localise(command, key, now);
    case msg::AgentCommand::Kind::stop:
      return stop(key, now);
    case msg::AgentCommand::Kind::resume:
      return resume(key, now);
    case msg::AgentCommand::Kind::keep_place:
      return keep_place(command, key, now);
    case msg::AgentCommand::Kind::teach_report:
      return teach_report(command, key);
    case msg::AgentCommand::Kind::counts:
      return tell_counts(key);
  }
  refuse(key, "this agent does not know the command");
}

void RobotAgent::answer(const msg::ClockProbe& probe, SteadyTime /*now*/, WallTime wall) {
  send(msg::ClockReply{
      .header = {}, .probe = probe.probe, .probe_sent = probe.sent, .received = wall, .replied = wall});
}

}  // namespace weft::agents
