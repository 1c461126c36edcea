#include "agents/agent/missions/upload_confirmation.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kConfirmedAtMost = 15s;
constexpr Duration kConfirmedOrRefinedAtMost = 30s;  ///< clients wait for 40 s

/// Returns whether something holds of an experience of the run.
template <class Holds>
bool any_of(const TaughtRun& run, const Holds& holds) {
  return holds(run.experience) || std::any_of(run.others.begin(), run.others.end(), holds);
}
}  // namespace

void UploadConfirmation::await(TaughtRun run, const CommandKey& asked_by, SteadyTime now) {
  awaited_ = Awaited{.run = std::move(run),
                     .asked_by = asked_by,
                     .deadline = now + kConfirmedAtMost,
                     .at_latest = now + kConfirmedOrRefinedAtMost};
}

void UploadConfirmation::tick(const Spooler& spooler, Replies& replies, SteadyTime now) {
  if (!awaited_.has_value()) return;
  const TaughtRun& run = awaited_->run;
  const bool held = any_of(run, [&](ExperienceId one) { return spooler.is_held(one); });
  if (held) awaited_->deadline = std::min(now + kConfirmedAtMost, awaited_->at_latest);
  const bool pending = held || any_of(run, [&](ExperienceId one) { return spooler.is_pending(one); });
  if (pending && now < awaited_->deadline) return;
  msg::AgentReply done = carried_out();
  done.experience = run.experience;
  done.reason = summary(run);
  if (held) {
    done.reason += "; it is still being refined: until it is handed in, it is on the robot's disk";
  } else if (pending) {
    done.reason += "; the server has not acknowledged all of it yet: the rest is on the robot's disk";
  }
  const CommandKey key = awaited_->asked_by;
  awaited_.reset();
  replies.give(key, std::move(done));
}

void UploadConfirmation::refused(ExperienceId experience, const std::string& reason, Replies& replies) {
  if (!awaited_.has_value()) return;
  const TaughtRun& run = awaited_->run;
  if (!any_of(run, [&](ExperienceId one) { return one == experience; })) return;
  replies.refuse(awaited_->asked_by, reason);
  awaited_.reset();
}

std::optional<SteadyTime> UploadConfirmation::next() const {
  return awaited_.has_value() ? std::optional(awaited_->deadline) : std::nullopt;
}

void UploadConfirmation::was_away(Duration away) {
  if (!awaited_.has_value()) return;
  awaited_->deadline += away;
  awaited_->at_latest += away;
}

}  // namespace weft::agents
