#include "agents/agent/robot/robot_agent.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace weft::agents {
namespace {

msg::Hello hello(const AgentConfig& config) {
  msg::Hello own;
  own.peer = config.self;
  own.incarnation = config.incarnation;
  own.role = msg::Role::agent;
  own.name = config.name;
  own.software = config.software;
  own.vendor = config.vendor;
  return own;
}

MapWindow::Limits map_limits(const AgentConfig& config) {
  return {.size = {.hops = config.window_hops, .cap = config.window_cap},
          .cache_bytes = config.content_cache_bytes,
          .bytes_per_second = config.bytes_per_second};
}

}  // namespace

RobotAgent::RobotAgent(const AgentConfig& config, std::unique_ptr<Navigator> navigator,
                       std::unique_ptr<SpoolWatch> spool, Spooler spooler, Random random, SteadyTime now)
    : config_(config),
      navigator_(std::move(navigator)),
      disk_{.spool = std::move(spool), .stops = StopMemory(*disk_.spool)},
      session_(hello(config), random.fork(1), now),
      outbox_(session_),
      replies_(outbox_),
      spooler_(std::move(spooler)),
      upload_(spooler_, config.bytes_per_second, now),
      map_(map_limits(config), (random.next() >> 1U) | 1U, now),
      recogniser_(random.next() >> 1U),
      ids_(random),
      reports_{.state = StateReporter(now), .power = {}},
      diagnostics_(navigator_->watched()),
      teach_({config_, *navigator_, map_, spooler_, ids_, replies_, outbox_}, now),
      localise_({config_.name, *navigator_, map_, recogniser_, replies_}, now),
      follow_({*navigator_, map_, outbox_}),
      keep_place_({config_, *navigator_, map_, spooler_, ids_, replies_}) {
  const storage::Stops stops = disk_.stops.kept();
  condition_.stopped = stops.by_operator;
  if (stops.by_emergency_stop) condition_.safety.restore();
}

AgentOutput RobotAgent::tick(SteadyTime now) {
  return finish(now);
}

AgentOutput RobotAgent::body_failed(const Error& error, SteadyTime now) {
  condition_.fault = error.message;
  navigator_->stop();
  if (teach_.is_active()) teach_.break_off("the body failed: " + error.message, now);
  follow_.fail(error.message, now);
  outbox_.note("body failed: " + error.message);
  return finish(now);
}

AgentOutput RobotAgent::leave(SteadyTime now) {
  navigator_->stop();
  condition_.command = Twist{};
  AgentOutput last = finish(now);
  msg::RobotState off = state(now);
  off.mode = msg::RobotMode::off;
  off.reason = "its agent was ended";
  outbox_.send(std::move(off));
  AgentOutput farewell = outbox_.take(Twist{});
  std::move(farewell.send.begin(), farewell.send.end(), std::back_inserter(last.send));
  return last;
}

AgentOutput RobotAgent::hand_answered(const Result<void>& answer, SteadyTime now) {
  if (std::optional<TeachMission::Answer> next_part = teach_.hand_answered(answer)) {
    outbox_.send(state(now));
    replies_.give(next_part->key, std::move(next_part->reply));
  }
  return finish(now);
}

void RobotAgent::work(SteadyTime now) {
  teach_.tick(now);
  keep_place_.tick(now);
  if (std::string note = learning_.hand_in(follow_.is_under_way(), spooler_, ids_, now); !note.empty()) {
    outbox_.note(std::move(note));
  }
  teach_.confirm(now);
  localise_.tick(now);
  search_if_due(now);
  follow_.tick(may_drive(), now);
}

void RobotAgent::search_if_due(SteadyTime now) {
  if (teach_.is_active() || localise_.is_active()) return;
  const SearchPolicy::Situation situation{
      .estimate = navigator_->estimate(),
      .has_route = follow_.has_route(),
      .strays = follow_.strays(),
      .is_held = condition_.lost || condition_.stopped || condition_.safety.holds(),
      .is_out_of_order = condition_.is_faulted()};
  if (localise_.search_if_due(situation, now) != LocaliseMission::Begun::anew) return;
  follow_.await_localisation(now);
  map_.look_anywhere(now);
}

void RobotAgent::send_due(SteadyTime now) {
  const auto send = [this](auto message) {
    if (message.has_value()) outbox_.send(std::move(*message));
  };
  for (std::string& dropped : session_.drop_claims(now)) outbox_.note(std::move(dropped));
  send(session_.due(now));
  if (reports_.state.description_due(now)) outbox_.send(description_of(config_, navigator_->drives()));
  if (msg::RobotState present = state(now); reports_.state.state_due(present, now)) outbox_.send(std::move(present));
  send(reports_.power.due(now));
  send(follow_.due(now));
  send(map_.window_due(now));
  send(recogniser_.due(now));
  if (const Result<void> sent = upload_.send_batches(outbox_, now); !sent) teach_.abandon(sent.error().message, now);
  send(map_.contents_due(now));
  upload_.send_chunks(outbox_, now);
}

AgentOutput RobotAgent::finish(SteadyTime now) {
  if (std::string note = disk_.stops.keep(condition_.stops(), now); !note.empty()) outbox_.note(std::move(note));
  disk_.spool->tick(now);
  work(now);
  send_due(now);
  condition_.command = condition_.allowed_command();
  return outbox_.take(condition_.command);
}

std::optional<SteadyTime> RobotAgent::next_tick() const {
  SteadyTime next = std::min({session_.next(), reports_.state.next(), map_.next()});
  const std::optional<SteadyTime> others[] = {upload_.next(),        recogniser_.next(),        teach_.next(),
                                              localise_.next(),      follow_.next(may_drive()), keep_place_.next(),
                                              reports_.power.next(), disk_.spool->next()};
  for (const std::optional<SteadyTime>& at : others) next = std::min(next, at.value_or(next));
  return next;
}

void RobotAgent::was_away(Duration away, SteadyTime now) {
  session_.was_away(away, now);
  teach_.was_away(away);
  localise_.was_away(away);
  follow_.was_away(away);
  keep_place_.was_away(away);
  ++seen_["agent: away from its inbox for more than a second"];
}

}  // namespace weft::agents
