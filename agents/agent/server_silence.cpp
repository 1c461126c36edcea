#include "agents/agent/server_silence.hpp"

#include <algorithm>
#include <chrono>

namespace weft::agents {
namespace {
constexpr Duration kGapRemembered = std::chrono::minutes(1);
}  // namespace

void ServerSilence::hear(SteadyTime now) {
  const Duration gap = now - heard_;
  const bool is_old = now - gap_ended_ > kGapRemembered;
  if (is_old || gap >= gap_) {
    gap_ = gap;
    gap_ended_ = now;
  }
  heard_ = now;
}

void ServerSilence::was_away(Duration away, SteadyTime now) {
  heard_ = std::min(heard_ + away, now);
}

Duration ServerSilence::longest(SteadyTime now) const {
  const bool is_old = now - gap_ended_ > kGapRemembered;
  return std::max(unheard(now), is_old ? Duration{} : gap_);
}

}  // namespace weft::agents
