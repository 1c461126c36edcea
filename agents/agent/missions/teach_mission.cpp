#include "agents/agent/missions/teach_mission.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kLastViewAtMost = 3s;

std::vector<SitePoint> line_of(const msg::AgentCommand& command) {
  std::vector<SitePoint> along;
  along.reserve(command.along.size());
  for (const msg::AgentCommand::Point& point : command.along) along.push_back({point.x, point.y});
  return along;
}

Result<void> check_start(const msg::AgentCommand& command, const AgentConfig& config, bool has_route,
                         bool is_stopped) {
  if (has_route) {
    return fail(ErrorCode::refused, config.name + " has a goal: cancel it, or wait until it is there");
  }
  if (!command.along.empty() && !config.can_be_taught_along) {
    return fail(ErrorCode::refused,
                "this body (" + config.body + ") has no hand that drives along a file: leave out --along");
  }
  if (is_stopped) return fail(ErrorCode::refused, config.name + " is stopped: resume it first");
  return {};
}
}  // namespace

bool TeachMission::start(const msg::AgentCommand& command, const CommandKey& key, const Condition& condition,
                         bool has_route, SteadyTime now) {
  if (condition.is_faulted()) {
    uses_.replies.refuse(key, uses_.config.name + " is out of order: " + condition.fault);
    return false;
  }
  if (teaching_.has_value()) {
    go_on(command, key, condition.stopped);
    return false;
  }
  const Result<void> allowed = check_start(command, uses_.config, has_route, condition.stopped);
  if (!allowed) {
    uses_.replies.refuse(key, allowed.error().message);
    return false;
  }
  confirmation_.drop();
  Result<TaughtRun> run = new_run(command.name, uses_.navigator.teaches(), uses_.ids);
  if (!run) {
    uses_.replies.refuse(key, run.error().message);
    return false;
  }
  Teaching teaching;
  teaching.run = std::move(*run);
  teaching.started_by = key;
  teaching.along = line_of(command);
  teaching.preparation.emplace(command.seed, teaching.along, now);
  teaching_ = std::move(teaching);
  return true;
}

/// Takes the same run asked for again: another line for the hand, or the repeat of a server that has forgotten that
/// it asked.
void TeachMission::go_on(const msg::AgentCommand& command, const CommandKey& key, bool is_stopped) {
  const AgentConfig& config = uses_.config;
  const bool same = !command.name.empty() && command.name == teaching_->run.name && teaching_->is_on() &&
                    !teaching_->next_part.has_value();
  if (!same) {
    return uses_.replies.refuse(key, config.name + " is being taught '" + teaching_->run.name + "': stop that first");
  }
  std::vector<SitePoint> along = line_of(command);
  if (along.empty() || along == teaching_->along) return uses_.replies.give(key, done());
  if (!config.can_be_taught_along) return uses_.replies.refuse(key, "this body (" + config.body + ") has no hand");
  if (is_stopped) return uses_.replies.refuse(key, config.name + " is stopped: resume it first");
  teaching_->along = std::move(along);
  teaching_->next_part = key;
  uses_.outbox.start_hand(teaching_->along);
}

void TeachMission::stop(const CommandKey& key, SteadyTime now) {
  if (!teaching_.has_value()) return uses_.replies.refuse(key, uses_.config.name + " is not being taught");
  if (teaching_->ending.has_value()) return uses_.replies.refuse(key, uses_.config.name + " is ending that already");
  if (teaching_->preparation.has_value()) {
    refuse_start("stopped before the map around the seed was there");
    msg::AgentReply nothing = carried_out();
    nothing.reason = "nothing was taught yet";
    return uses_.replies.give(key, std::move(nothing));
  }
  uses_.outbox.stop_hand();
  teaching_->ending = Ending{.asked_by = key, .deadline = now + kLastViewAtMost};
}

void TeachMission::keep_place(const CommandKey& key, SteadyTime now) {
  if (!teaching_.has_value() || !teaching_->is_on()) {
    return uses_.replies.refuse(key, "teaching has not begun or is ending: try again");
  }
  requests_.add(key, now);
  uses_.navigator.keep_place();
}

std::optional<TeachMission::Answer> TeachMission::hand_answered(const Result<void>& answer) {
  if (!teaching_.has_value()) return std::nullopt;
  if (teaching_->preparation.has_value()) {
    if (!teaching_->preparation->awaits_hand()) return std::nullopt;
    if (answer) {
      begin();
    } else {
      refuse_start(answer.error().message);
    }
    return std::nullopt;
  }
  if (!teaching_->next_part.has_value()) return std::nullopt;
  const CommandKey key = *std::exchange(teaching_->next_part, std::nullopt);
  if (!answer) {
    uses_.replies.refuse(key, answer.error().message);
    return std::nullopt;
  }
  teaching_->hand_done = false;
  return Answer{.key = key, .reply = done()};
}

void TeachMission::refuse_start(const std::string& reason) {
  uses_.replies.refuse(teaching_->started_by, reason);
  teaching_.reset();
}

bool TeachMission::on_fix() {
  const bool awaited = teaching_.has_value() && teaching_->preparation.has_value() && teaching_->preparation->seeks();
  if (awaited && teaching_->preparation->on_fix(preparing()) == TeachPreparation::Step::begins) begin();
  return awaited;
}

void TeachMission::tick(SteadyTime now) {
  if (teaching_.has_value() && teaching_->preparation.has_value()) {
    const Result<TeachPreparation::Step> step = teaching_->preparation->tick(preparing(), now);
    if (!step) {
      refuse_start(step.error().message);
    } else if (*step == TeachPreparation::Step::begins) {
      begin();
    }
  }
  if (teaching_.has_value() && teaching_->ending.has_value() && now >= teaching_->ending->deadline) end(now);
  requests_.tick(uses_.replies, now);
}

void TeachMission::begin() {
  const TaughtRun& run = teaching_->run;
  teaching_->preparation.reset();
  uses_.navigator.begin_teach({.experience = run.experience, .robot = uses_.config.self, .others = run.others});
  uses_.spooler.begin(run.experience, run.name);
  const std::vector<std::string> methods = uses_.navigator.teaches();
  for (std::size_t i = 0; i < run.others.size(); ++i) {
    uses_.spooler.begin(run.others[i], name_of_other(run.name, methods[i + 1]));
  }
  uses_.replies.give(teaching_->started_by, done());
}

msg::AgentReply TeachMission::done() const {
  msg::AgentReply done = carried_out();
  done.experience = teaching_->run.experience;
  return done;
}

void TeachMission::step(const std::vector<Kept>& kept, bool hand_done, SteadyTime now) {
  keep(kept, now);
  if (!teaching_.has_value()) return;
  teaching_->hand_done = hand_done;
  if (!teaching_->ending.has_value()) return;
  keep(uses_.navigator.end_teach(uses_.map.view()), now);
  // The spool may not have taken it.
  if (teaching_.has_value() && !uses_.navigator.is_taught()) end(now);
}

void TeachMission::keep(const std::vector<Kept>& kept, SteadyTime now) {
  if (!teaching_.has_value()) return;
  if (const Result<void> spooled = try_keep(kept, now); !spooled) abandon(spooled.error().message, now);
}

Result<void> TeachMission::try_keep(const std::vector<Kept>& kept, SteadyTime now) {
  for (const Kept& one : kept) {
    uses_.map.put(one.place.content.hash, one.content);
    if (Result<void> added = uses_.spooler.add(one, now); !added) return added;
    teaching_->run.count(one);
  }
  if (kept.empty() || requests_.empty()) return {};
  if (Result<void> flushed = uses_.spooler.flush(now); !flushed) return flushed;
  requests_.answer(kept.back().place.id, uses_.replies);
  return {};
}

void TeachMission::end(SteadyTime now) {
  uses_.navigator.leave_teach();
  const Ending ending = *teaching_->ending;
  const Result<void> sealed = uses_.spooler.seal("taught to its end", now);
  if (sealed) {
    confirmation_.await(std::move(teaching_->run), ending.asked_by, now);
  } else {
    msg::AgentReply failed = done();
    failed.done = false;
    failed.reason = sealed.error().message;
    failure_ = "teaching ended: " + failed.reason;
    uses_.navigator.forget_taught(uses_.map.window());
    uses_.replies.give(ending.asked_by, std::move(failed));
  }
  teaching_.reset();
  requests_.refuse_all("teaching ended before a place was kept", uses_.replies);
}

void TeachMission::break_off(const std::string& reason, SteadyTime now) {
  bool is_spooled = true;
  for (const Kept& last : uses_.navigator.end_teach(uses_.map.view())) {
    is_spooled = bool(uses_.spooler.add(last, now)) && is_spooled;
  }
  uses_.navigator.leave_teach();
  // What has been taught until then stays, as far as the spool takes it.
  is_spooled = bool(uses_.spooler.seal("teaching broke off", now)) && is_spooled;
  if (!is_spooled) uses_.navigator.forget_taught(uses_.map.window());
  uses_.outbox.stop_hand();
  failure_ = reason;
  uses_.outbox.note(reason);
  const Teaching ended = std::move(*std::exchange(teaching_, std::nullopt));
  if (ended.preparation.has_value()) uses_.replies.refuse(ended.started_by, reason);
  if (ended.ending.has_value()) uses_.replies.refuse(ended.ending->asked_by, reason);
  if (ended.next_part.has_value()) uses_.replies.refuse(*ended.next_part, reason);
  requests_.refuse_all(reason, uses_.replies);
}

void TeachMission::abandon(const std::string& reason, SteadyTime now) {
  if (teaching_.has_value()) break_off("teaching ended: " + reason, now);
  uses_.navigator.forget_taught(uses_.map.window());
}

void TeachMission::refused(ExperienceId experience, const Spooler::Heard& heard, SteadyTime now) {
  if (heard.refused) {
    abandon(heard.reason, now);
  } else if (!heard.lessons) {
    uses_.navigator.forget_taught(uses_.map.window());
  }
  confirmation_.refused(experience, heard.reason, uses_.replies);
}

std::optional<ExperienceId> TeachMission::experience() const {
  return teaching_.has_value() ? std::optional(teaching_->run.experience) : std::nullopt;
}

std::string TeachMission::waits_for() const {
  if (!teaching_.has_value()) return {};
  if (teaching_->preparation.has_value()) {
    if (std::string what = teaching_->preparation->waits_for(); !what.empty()) return what;
  }
  return teaching_->hand_done ? "hand_done" : std::string{};
}

std::optional<SteadyTime> TeachMission::next() const {
  std::optional<SteadyTime> next = requests_.next();
  const auto sooner = [&next](const std::optional<SteadyTime>& at) {
    if (at.has_value()) next = next.has_value() ? std::min(*next, *at) : at;
  };
  if (teaching_.has_value() && teaching_->preparation.has_value()) sooner(teaching_->preparation->next());
  if (teaching_.has_value() && teaching_->ending.has_value()) sooner(teaching_->ending->deadline);
  sooner(confirmation_.next());
  return next;
}

void TeachMission::was_away(Duration away) {
  requests_.was_away(away);
  confirmation_.was_away(away);
  if (!teaching_.has_value()) return;
  if (teaching_->preparation.has_value()) teaching_->preparation->was_away(away);
  if (teaching_->ending.has_value()) teaching_->ending->deadline += away;
}

}  // namespace weft::agents
