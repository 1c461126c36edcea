#include <utility>

#include "agents/agent/spooler.hpp"

namespace weft::agents {

/// Ends an open experience that the spool does not take any more: what it has of it is handed in as it is, and sealed
/// once there is room for that. Until then the server would wait for more of it.
void Spooler::give_up(ExperienceId experience, SteadyTime now) {
  const bool was_held = held_.erase(experience) > 0;
  const auto open = open_.find(experience);
  if (open == open_.end()) return;
  Batch seal = std::move(open->second.batch);
  open_.erase(open);
  if (seal.sequence == 1) return;  // nothing of it was spooled
  seal.places.clear();
  seal.learned.clear();
  seal.edges.clear();
  seal.seal = true;
  seal.seal_reason = "its robot's disk took no more of it";
  if (was_held) seal.seal_reason += kUnrefinedSeal;
  cut_short_.insert_or_assign(experience, std::move(seal));
  seal_at_ = now + config_.retry;
}

void Spooler::seal_cut_short(SteadyTime now) {
  if (cut_short_.empty() || now < seal_at_) return;
  seal_at_ = now + config_.retry;
  while (!cut_short_.empty()) {
    const auto first = cut_short_.begin();
    const Result<void> appended = spool_->append(first->second, {});
    // The spool has the batch after all that it had refused: the next start seals after that.
    const bool is_settled = !appended && appended.error().code == ErrorCode::conflict;
    if (!appended && !is_settled) return;
    Batch seal = std::move(first->second);
    cut_short_.erase(first);
    if (is_settled) continue;
    unsealed_.erase(seal.experience);
    pending_.push_back({.batch = std::move(seal), .send_at = now, .wait = config_.retry});
  }
}

}  // namespace weft::agents
