#include <map>
#include <utility>

#include "agents/agent/spooler.hpp"

namespace weft::agents {

Result<Spooler> Spooler::open(storage::Spool& spool, const SpoolerConfig& config, RobotId self, SteadyTime now) {
  Spooler spooler(spool, config, self);
  Result<std::vector<Batch>> pending = spool.pending();
  if (!pending) return fail(pending.error());
  for (Batch& batch : *pending) {
    spooler.pending_.push_back({.batch = std::move(batch), .send_at = now, .wait = config.retry});
  }
  if (Result<void> sealed = spooler.seal_what_a_crash_left_open(now); !sealed) return fail(sealed.error());
  return spooler;
}

Result<void> Spooler::seal_what_a_crash_left_open(SteadyTime now) {
  std::map<ExperienceId, Batch> seals;
  for (const Pending& pending : pending_) {
    const Batch& last = pending.batch;
    seals.erase(last.experience);
    if (last.seal) continue;
    Batch seal;
    seal.experience = last.experience;
    seal.sequence = last.sequence + 1;
    seal.robot = last.robot;
    seal.name = last.name;
    seal.method = last.method;
    seal.seal = true;
    seal.seal_reason =
        last.places.empty() ? "the agent was restarted" : "the agent was restarted while it was being taught";
    seals.emplace(last.experience, std::move(seal));
  }
  for (auto& [experience, seal] : seals) {
    if (Result<void> appended = spool_->append(seal, {}); !appended) return appended;
    pending_.push_back({.batch = std::move(seal), .send_at = now, .wait = config_.retry});
  }
  return {};
}

}  // namespace weft::agents
