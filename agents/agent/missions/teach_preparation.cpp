#include "agents/agent/missions/teach_preparation.hpp"

#include <utility>

#include "agents/agent/missions/waits.hpp"
#include "agents/agent/surroundings.hpp"

namespace weft::agents {

TeachPreparation::TeachPreparation(const std::optional<PlaceId>& seed, std::vector<SitePoint> along, SteadyTime now)
    : seed_(seed), along_(std::move(along)), deadline_(now + kMapAtMost) {}

Result<TeachPreparation::Step> TeachPreparation::tick(const Uses& uses, SteadyTime now) {
  switch (phase_) {
    case Phase::map:
      return await_map(uses, now);
    case Phase::search:
      if (now < deadline_) return Step::waits;
      uses.navigator.seek(std::nullopt);  // the seed has led to nothing
      return fail(ErrorCode::refused, uses.robot + " did not find itself around " + to_string(*seed_) +
                                          ": move it nearer, or teach without a seed");
    case Phase::hand:
      break;
  }
  return Step::waits;
}

Result<TeachPreparation::Step> TeachPreparation::await_map(const Uses& uses, SteadyTime now) {
  if (!seed_.has_value()) return start_hand(uses);
  const bool ready =
      uses.map.replica().is_settled() && is_covered(uses.map.view(), uses.navigator.teaches(), *seed_, kSeedHops);
  if (!ready) {
    if (now < deadline_) return Step::waits;
    return fail(ErrorCode::refused,
                "the map around " + to_string(*seed_) + " did not arrive in 20 s: is that place in `weft map info`?");
  }
  phase_ = Phase::search;
  deadline_ = now + kSearchAtMost;
  uses.navigator.seek(seed_);
  return Step::waits;
}

TeachPreparation::Step TeachPreparation::start_hand(const Uses& uses) {
  if (along_.empty()) return Step::begins;
  phase_ = Phase::hand;
  uses.outbox.start_hand(along_);
  return Step::waits;
}

std::string TeachPreparation::waits_for() const {
  switch (phase_) {
    case Phase::map:
      return "waits for the map around its seed";
    case Phase::search:
      return "looks for itself around its seed";
    case Phase::hand:
      break;
  }
  return {};
}

std::optional<SteadyTime> TeachPreparation::next() const {
  const bool limited = phase_ == Phase::search || (phase_ == Phase::map && seed_.has_value());
  return limited ? std::optional(deadline_) : std::nullopt;
}

}  // namespace weft::agents
