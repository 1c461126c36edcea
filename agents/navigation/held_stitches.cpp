#include "agents/navigation/held_stitches.hpp"

#include <utility>

namespace weft::agents {

void HeldStitches::take(const std::vector<Edge>& stitches, double driven_m) {
  if (stitches.empty()) return;
  if (!held_.empty()) beside_m_ += driven_m - stitched_m_;
  stitched_m_ = driven_m;
  held_.insert(held_.end(), stitches.begin(), stitches.end());
}

void HeldStitches::contradict(const ExperienceId& other, double by) {
  if (is_proven_ || by <= 0.0) return;
  contradiction_ += by;
  doubted_.insert(other);
}

std::optional<Refusal> HeldStitches::disproved() {
  if (contradiction_ <= config_.most_contradiction) return std::nullopt;
  elsewhere_.merge(doubted_);
  for (const Edge& stitch : held_) elsewhere_.insert(stitch.id.a.experience);
  const Refusal refusal{"looks_like_another", contradiction_, config_.most_contradiction};
  rest();
  return refusal;
}

std::vector<Edge> HeldStitches::proven(double driven_m) {
  if (held_.empty()) return {};
  is_proven_ = is_proven_ || beside_m_ > config_.proven_m;
  if (is_proven_) return std::exchange(held_, {});
  // Where the run comes upon others again, that is proven anew.
  const bool has_parted = driven_m - stitched_m_ > config_.parted_m;
  return has_parted ? rest() : std::vector<Edge>{};
}

std::vector<Edge> HeldStitches::rest() {
  contradiction_ = 0.0;
  beside_m_ = 0.0;
  doubted_.clear();
  return std::exchange(held_, {});
}

std::optional<PlaceId> HeldStitches::beside() const {
  return held_.empty() ? std::nullopt : std::optional(held_.back().id.a);
}

}  // namespace weft::agents
