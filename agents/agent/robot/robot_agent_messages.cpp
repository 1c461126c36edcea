#include <utility>

#include "agents/agent/robot/robot_agent.hpp"
#include "core/overloaded.hpp"

namespace weft::agents {
namespace {

msg::ClockReply answer(const msg::ClockProbe& probe, WallTime wall) {
  return {.header = {}, .probe = probe.probe, .probe_sent = probe.sent, .received = wall, .replied = wall};
}

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
                   if (admit(m.header, m.to, now)) outbox_.send(answer(m, wall));
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
  outbox_.note("server: epoch " + std::to_string(session_.epoch().value));
  spooler_.server_restarted(now);
  map_.server_restarted(now);
  recogniser_.server_restarted(now);
  follow_.server_restarted(now);
  reports_.state.server_restarted(now);
  reports_.power.server_restarted(now);
}

void RobotAgent::on(const msg::Hello& hello, SteadyTime now) {
  if (hello.role == msg::Role::server) heard(session_.hear(hello, now), now);
}

void RobotAgent::on(const msg::BatchAck& ack, SteadyTime now) {
  const Spooler::Heard heard = spooler_.on_ack(ack, now);
  outbox_.record(heard.acknowledged);
  if (heard.reason.empty()) return;
  outbox_.note(heard.reason);
  teach_.refused(ack.experience, heard, now);
}

void RobotAgent::on(const msg::Chunk& chunk, SteadyTime now) {
  if (chunk.kind == msg::ContentKind::content) map_.on_chunk(chunk, now);
}

void RobotAgent::on(const msg::ContentRequest& request, SteadyTime now) {
  spooler_.on_request(request, now);
}

void RobotAgent::on(const msg::WindowPatch& patch, SteadyTime now) {
  if (map_.replica().is_own(patch)) session_.answered(patch.header);
  std::string note = map_.on_patch(patch, map_context(), localise_.has_seed(), now);
  if (!note.empty()) outbox_.note(std::move(note));
}

void RobotAgent::on(const msg::Recognised& answer, SteadyTime now) {
  std::optional<Recogniser::Heard> heard = recogniser_.on_answer(answer);
  if (!heard.has_value()) return;
  if (map_.is_news(heard->note)) outbox_.note(std::move(heard->note));
  navigator_->propose(heard->question, heard->places);
  map_.look_at(std::move(heard->places), map_context(), now);
}

void RobotAgent::on(const msg::RouteOrder& order, SteadyTime now) {
  if (!session_.is_meant_for_me(order.header, now)) return;
  // The server learns from our state that we are being taught.
  if (teach_.is_active() && !order.route.ended) return;
  switch (follow_.take(order.route, condition_.is_kept_standing(), now)) {
    case FollowMission::Took::nothing:
      return;
    case FollowMission::Took::end:
      condition_.command = Twist{};
      reports_.state.hurry(now);
      break;
    case FollowMission::Took::route:
      break;
  }
  map_.hold_route(map_context(), now);
}

}  // namespace weft::agents
