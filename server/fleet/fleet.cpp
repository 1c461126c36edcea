#include "server/fleet/fleet.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/protocol/version.hpp"
#include "core/text.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenProbes = 10s;
constexpr std::size_t kMostRobots = 10'000;

std::string call_for_help(const std::string& name, const msg::RobotState& state) {
  std::string text = "it stands and needs help (" + state.reason + ")";
  if (state.place.experience) text += "; it was last sure of itself by place " + to_string(state.place);
  return text + "; if it does not find itself, see where it stands: weft localise " + name + " --at LABEL";
}
}  // namespace

std::string unreachable_reason(const Robot& robot) {
  if (robot.incarnations.twins()) {
    return robot.name + " runs twice: two live agents share its id; end one of them";
  }
  if (robot.silent) return robot.name + " is not heard: is its agent running?";
  if (!robot.description) return robot.name + " has not said yet what it can do";
  return {};
}

Fleet::Fleet(Context& context, Random random, const std::map<RobotId, std::string>& stored,
             const std::map<RobotId, std::string>& holds, SteadyTime now)
    : context_(context), random_(random), silent_after_(from_seconds(context.config.robot_silent_after_s)) {
  for (const auto& [id, name] : stored) {
    if (name.empty()) continue;  // forgotten
    Robot& robot = robots_[id];
    robot.id = id;
    robot.name = name;
    robot.heard = now;
    robot.next_probe = now;
    if (const auto held = holds.find(id); held != holds.end()) robot.held_by = held->second;
  }
}

Robot& Fleet::entry(const RobotId& id, Now now) {
  const auto [at, is_new] = robots_.try_emplace(id);
  if (is_new) {
    at->second.id = id;
    at->second.heard = now.steady;
    at->second.next_probe = now.steady;
  }
  return at->second;
}

bool Fleet::on_hello(const msg::Hello& hello, Now now) {
  const Result<std::uint16_t> version = msg::negotiate({}, hello);
  if (!version) {
    ++context_.counters["hello: no protocol version in common"];
    const bool is_new = refused_.size() < kMostRobots && refused_.insert(hello.peer).second;
    if (is_new) {
      context_.writer.note({.at = {},
                            .kind = "peer.refused",
                            .robot = hello.role == msg::Role::agent ? hello.peer : PeerId{},
                            .goal = {},
                            .cause = version.error().message,
                            .who = hello.name},
                           now);
    }
    return false;
  }
  refused_.erase(hello.peer);
  if (hello.role != msg::Role::agent) return true;
  if (robots_.size() >= kMostRobots && !robots_.contains(hello.peer)) return false;
  Robot& robot = entry(hello.peer, now);
  robot.vendor = hello.vendor;
  robot.software = hello.software;
  named(robot, hello.name, now);
  return true;
}

void Fleet::named(Robot& robot, const std::string& name, Now now) {
  if (robot.name == name || name.empty()) return;
  const bool was_nameless = robot.name.empty();
  // If it cannot be kept, the next description brings it again.
  const bool is_kept = context_.writer.commit({{storage::PutRobot{robot.id, name}}}, now).has_value();
  if (is_kept || was_nameless) robot.name = name;
  if (was_nameless && !robot.silent) note("robot.heard", robot, "it speaks", now);
}

void Fleet::on_description(const msg::RobotDescription& description, Now now) {
  const auto found = robots_.find(description.header.sender);
  if (found == robots_.end()) return;
  named(found->second, description.name, now);
  found->second.description = description;
}

void Fleet::count(const msg::Header& from, SteadyTime now) {
  const auto found = robots_.find(from.sender);
  if (found != robots_.end()) found->second.reception.hear(from.incarnation, from.sequence, now);
}

std::optional<Incarnations::Verdict> Fleet::hear(const msg::Header& from, bool says_it_is_a_robot, Now now) {
  const bool is_known = robots_.contains(from.sender);
  if (!is_known && (!says_it_is_a_robot || robots_.size() >= kMostRobots)) return std::nullopt;
  Robot& robot = entry(from.sender, now);
  const bool were_twins = robot.incarnations.twins();
  const Incarnations::Verdict verdict = robot.incarnations.hear(from.incarnation, now.steady);
  if (verdict == Incarnations::Verdict::late) return verdict;
  const Duration silence = now.steady - robot.heard;
  robot.heard = now.steady;
  robot.left = false;
  if (robot.silent) {
    robot.silent = false;
    const bool is_same = robot.state && verdict != Incarnations::Verdict::fresh;
    robot.directions.heard_again(is_same ? std::optional(silence) : std::nullopt, now.steady);
    // A new robot's state can come before the hello that names it.
    if (!robot.name.empty()) note("robot.heard", robot, "it speaks", now);
  }
  if (verdict == Incarnations::Verdict::fresh) {
    robot.state.reset();
    robot.skew = ClockSkew{};
    robot.next_probe = now.steady;
  }
  if (robot.incarnations.twins() && !were_twins) {
    robot.state.reset();
    note("robot.twins", robot, "two live agents share one id; both are held: end one of them, then resume the robot",
         now);
  }
  return verdict;
}

void Fleet::on_power(const msg::RobotPower& power) {
  const auto found = robots_.find(power.header.sender);
  if (found == robots_.end()) return;
  std::optional<msg::RobotPower>& last = found->second.power;
  const bool is_late =
      last && last->header.incarnation == power.header.incarnation && last->header.sequence >= power.header.sequence;
  if (!is_late) last = power;
}

const Robot* Fleet::on_state(const msg::RobotState& state, Now now) {
  const auto found = robots_.find(state.header.sender);
  if (found == robots_.end()) return nullptr;
  Robot& robot = found->second;
  if (robot.state && robot.state->header.sequence >= state.header.sequence) return nullptr;
  changed(robot, state, now);
  robot.state = state;
  robot.left = state.mode == msg::RobotMode::off && !robot.incarnations.twins();
  return &robot;
}

void Fleet::changed(Robot& robot, const msg::RobotState& next, Now now) {
  const bool was_lost = robot.state && robot.state->mode == msg::RobotMode::lost;
  const bool was_faulted = robot.state && robot.state->mode == msg::RobotMode::faulted;
  const bool is_lost = next.mode == msg::RobotMode::lost;
  const bool is_faulted = next.mode == msg::RobotMode::faulted;
  if (is_lost && !was_lost) note("robot.lost", robot, call_for_help(robot.name, next), now);
  if (was_lost && !is_lost) note("robot.found", robot, "it knows again where it is", now);
  if (is_faulted && !was_faulted) note("robot.faulted", robot, next.reason, now);
  if (const auto told = robot.directions.hear(next, now.steady)) note(told->kind, robot, told->cause, now);
}

void Fleet::on_clock_reply(const msg::ClockReply& reply, Now now) {
  const auto found = robots_.find(reply.header.sender);
  if (found != robots_.end()) found->second.skew.answered(reply, now);
}

std::vector<RobotId> Fleet::tick(Now now) {
  std::vector<RobotId> fell_silent;
  for (auto& [id, robot] : robots_) {
    if (robot.silent) continue;
    if (robot.left || now.steady - robot.heard >= silent_after_) {
      robot.silent = true;
      const std::string unheard =
          "nothing heard of it for " + short_number(context_.config.robot_silent_after_s) + " s";
      note("robot.silent", robot, robot.left ? "its agent was ended" : unheard, now);
      fell_silent.push_back(id);
      continue;
    }
    if (robot.incarnations.settle(now.steady, silent_after_)) {
      note("robot.twins_ended", robot, "only one agent of this id is heard", now);
    }
    if (robot.next_probe > now.steady) continue;
    robot.next_probe = now.steady + kBetweenProbes;
    const std::uint64_t probe = random_.next() | 1U;
    robot.skew.sent(probe, now.steady);
    context_.out.send(msg::ClockProbe{.header = {}, .to = id, .probe = probe, .sent = now.wall});
  }
  return fell_silent;
}

void Fleet::excuse(Duration away, SteadyTime now) {
  for (auto& [id, robot] : robots_) {
    if (robot.silent) continue;
    robot.heard = std::min(robot.heard + away, now);
    robot.incarnations.excuse(away, now);
    robot.directions.server_was_away(now);
  }
}

std::optional<SteadyTime> Fleet::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [id, robot] : robots_) {
    if (robot.silent) continue;
    const SteadyTime due = robot.left ? robot.heard : std::min(robot.heard + silent_after_, robot.next_probe);
    if (!next || due < *next) next = due;
  }
  return next;
}

const Robot* Fleet::find(const RobotId& id) const {
  const auto found = robots_.find(id);
  return found == robots_.end() ? nullptr : &found->second;
}

std::string Fleet::name_of(const RobotId& id) const {
  const Robot* const robot = find(id);
  return robot == nullptr || robot->name.empty() ? to_string(id) : robot->name;
}

void Fleet::note(const char* kind, const Robot& robot, const std::string& cause, Now now) {
  context_.writer.note({.at = {}, .kind = kind, .robot = robot.id, .goal = {}, .cause = cause, .who = robot.name},
                       now);
}

void Fleet::sent_window(const PeerId& to, std::size_t bytes) {
  if (const auto robot = robots_.find(to); robot != robots_.end()) robot->second.window_bytes += bytes;
}

void Fleet::sent_content(const PeerId& to, std::size_t bytes) {
  if (const auto robot = robots_.find(to); robot != robots_.end()) robot->second.content_bytes += bytes;
}

}  // namespace weft::server
