#include <algorithm>
#include <utility>

#include "agents/agent/refined_run.hpp"
#include "agents/agent/spooler.hpp"

namespace weft::agents {

Result<void> Spooler::hand_in(ExperienceId experience, RunAmendments amendments) {
  const auto held = held_.find(experience);
  if (held == held_.end() || open_.contains(experience)) {
    return fail(ErrorCode::conflict, "experience " + to_string(experience) + " is not held back, or not sealed yet");
  }
  std::vector<Batch> draft;
  for (const Pending& pending : pending_)
    if (pending.batch.experience == experience) draft.push_back(pending.batch);
  const std::string seal_reason = std::move(held->second);
  held_.erase(held);  // whatever comes of it, it is sent
  Result<RefinedRun> run = make_refined_run(std::move(draft), std::move(amendments), seal_reason);
  if (!run) return fail(run.error());
  const Result<void> replaced = spool_->replace(experience, run->batches, run->contents);
  // After an error of the disk, the spool knows which of both it has.
  Result<std::vector<Batch>> there = replaced ? std::move(run->batches) : spool_->pending();
  if (!there) return fail(there.error());
  for (Batch& batch : *there) {
    const auto found = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& pending) {
      return pending.batch.experience == experience && pending.batch.sequence == batch.sequence;
    });
    if (batch.experience == experience && found != pending_.end()) found->batch = std::move(batch);
  }
  return replaced;
}

}  // namespace weft::agents
