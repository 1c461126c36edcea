#include "agents/agent/missions/teach_mission.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "agents/agent/missions/teach_command.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kLastViewAtMost = 3s;
}  // namespace

bool TeachMission::start(const msg::AgentCommand& command, const CommandKey& key, const Condition& condition,
                         bool has_route, SteadyTime now) {
  if (teaching_.has_value() && !condition.is_faulted()) {
    go_on(command, key, condition);
    return false;
  }
  Result<TaughtRun> run = run_for(command, condition, has_route);
  if (!run) {
    uses_.replies.refuse(key, run.error().message);
    return false;
  }
  const RunRecorder::Uses recording{uses_.config.self, uses_.navigator, uses_.map, uses_.spooler, refining_};
  const std::vector<SitePoint> along = line_of(command);
  teaching_.emplace(Teaching{.recorder = RunRecorder(recording, std::move(*run)),
                             .started_by = key,
                             .along = along,
                             .preparation = TeachPreparation(command.seed, along, now)});
  return true;
}

Result<TaughtRun> TeachMission::run_for(const msg::AgentCommand& command, const Condition& condition,
                                        bool has_route) {
  const Result<void> allowed = check_teach_start(command, uses_.config, condition, has_route);
  if (!allowed) return fail(allowed.error());
  confirmation_.drop();
  return new_run(command.name, uses_.navigator.teaches(), uses_.ids);
}

/// Takes the same run asked for again: another line for the hand, or the repeat of a server that has forgotten that
/// it asked.
void TeachMission::go_on(const msg::AgentCommand& command, const CommandKey& key, const Condition& condition) {
  const std::string& name = teaching_->recorder.run().name;
  const bool same =
      !command.name.empty() && command.name == name && teaching_->is_on() && !teaching_->next_part.has_value();
  if (!same) {
    return uses_.replies.refuse(key, uses_.config.name + " is being taught '" + name + "': stop that first");
  }
  std::vector<SitePoint> along = line_of(command);
  if (along.empty() || along == teaching_->along) return uses_.replies.give(key, done());
  if (const Result<void> allowed = check_next_part(uses_.config, condition); !allowed) {
    return uses_.replies.refuse(key, allowed.error().message);
  }
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
  refining_.tick(now);
}

void TeachMission::begin() {
  teaching_->preparation.reset();
  teaching_->recorder.begin();
  uses_.replies.give(teaching_->started_by, done());
}

msg::AgentReply TeachMission::done() const {
  msg::AgentReply done = carried_out();
  done.experience = teaching_->recorder.run().experience;
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
  if (Result<void> recorded = teaching_->recorder.keep(kept, now); !recorded) return recorded;
  if (kept.empty() || requests_.empty()) return {};
  if (Result<void> flushed = teaching_->recorder.flush(now); !flushed) return flushed;
  requests_.answer(kept.back().place.id, uses_.replies);
  return {};
}

void TeachMission::end(SteadyTime now) {
  const CommandKey asked_by = teaching_->ending->asked_by;
  const Result<void> sealed = teaching_->recorder.seal(now);
  if (sealed) {
    confirmation_.await(teaching_->recorder.run(), asked_by, now);
  } else {
    msg::AgentReply failed = done();
    failed.done = false;
    failed.reason = sealed.error().message;
    failure_ = "teaching ended: " + failed.reason;
    uses_.replies.give(asked_by, std::move(failed));
  }
  teaching_.reset();
  requests_.refuse_all("teaching ended before a place was kept", uses_.replies);
}

void TeachMission::break_off(const std::string& reason, SteadyTime now) {
  teaching_->recorder.break_off(now);
  uses_.outbox.stop_hand();
  failure_ = reason;
  uses_.outbox.note(reason);
  if (teaching_->preparation.has_value()) uses_.replies.refuse(teaching_->started_by, reason);
  if (teaching_->ending.has_value()) uses_.replies.refuse(teaching_->ending->asked_by, reason);
  if (teaching_->next_part.has_value()) uses_.replies.refuse(*teaching_->next_part, reason);
  teaching_.reset();
  requests_.refuse_all(reason, uses_.replies);
}

void TeachMission::abandon(const std::string& reason, SteadyTime now) {
  if (teaching_.has_value()) break_off("teaching ended: " + reason, now);
  uses_.navigator.forget_taught(uses_.map.window());
}

void TeachMission::refused(ExperienceId experience, const Spooler::Heard& heard, SteadyTime now) {
  if (heard.refused) {
    abandon(heard.reason, now);
  } else if (!heard.learned_places) {
    uses_.navigator.forget_taught(uses_.map.window());
  }
  confirmation_.refused(experience, heard.reason, uses_.replies);
}

std::optional<ExperienceId> TeachMission::experience() const {
  return teaching_.has_value() ? std::optional(teaching_->recorder.run().experience) : std::nullopt;
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
  sooner(refining_.next());
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
