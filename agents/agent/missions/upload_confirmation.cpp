#include "agents/agent/missions/upload_confirmation.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kConfirmedAtMost = 15s;
}  // namespace

void UploadConfirmation::await(TaughtRun run, const CommandKey& asked_by, SteadyTime now) {
  awaited_ = Awaited{.run = std::move(run), .asked_by = asked_by, .deadline = now + kConfirmedAtMost};
}

void UploadConfirmation::tick(const Spooler& spooler, Replies& replies, SteadyTime now) {
  if (!awaited_.has_value()) return;
  const TaughtRun& run = awaited_->run;
  const bool pending = spooler.is_pending(run.experience) ||
                       std::any_of(run.others.begin(), run.others.end(),
                                   [&](ExperienceId other) { return spooler.is_pending(other); });
  if (pending && now < awaited_->deadline) return;
  msg::AgentReply done = carried_out();
  done.experience = run.experience;
  done.reason = summary(run);
  if (pending) done.reason += "; the server has not acknowledged all of it yet: the rest is on the robot's disk";
  const CommandKey key = awaited_->asked_by;
  awaited_.reset();
  replies.give(key, std::move(done));
}

void UploadConfirmation::refused(ExperienceId experience, const std::string& reason, Replies& replies) {
  if (!awaited_.has_value()) return;
  const TaughtRun& run = awaited_->run;
  const bool concerned =
      run.experience == experience || std::find(run.others.begin(), run.others.end(), experience) != run.others.end();
  if (!concerned) return;
  replies.refuse(awaited_->asked_by, reason);
  awaited_.reset();
}

std::optional<SteadyTime> UploadConfirmation::next() const {
  return awaited_.has_value() ? std::optional(awaited_->deadline) : std::nullopt;
}

void UploadConfirmation::was_away(Duration away) {
  if (awaited_.has_value()) awaited_->deadline += away;
}

}  // namespace weft::agents
