#include "agents/navigation/held_stitches.hpp"

#include <algorithm>
#include <utility>

namespace weft::agents {

void HeldStitches::take(const AtPlace& found, double driven_m) {
  if (driven_m - near_m_ > config_.parted_m && held_.empty()) part();
  if (found.is_beside) near_m_ = driven_m;
  if (!is_proven_) {
    for (const auto& [other, by] : found.contradictions)
      if (by > 0.0) contradictions_[other] += std::min(by, config_.most_contradiction_of_a_place);
  }
  if (found.stitches.empty()) return;
  // A way on which nothing was recognised proves little.
  if (!held_.empty()) beside_m_ += std::min(driven_m - stitched_m_, config_.parted_m);
  stitched_m_ = near_m_ = driven_m;
  held_.insert(held_.end(), found.stitches.begin(), found.stitches.end());
}

std::optional<Refusal> HeldStitches::disproved() {
  const auto worst = std::ranges::max_element(contradictions_, {}, [](const auto& one) { return one.second; });
  if (worst == contradictions_.end() || worst->second <= config_.most_contradiction) return std::nullopt;
  const Refusal refusal{"told_apart", worst->second, config_.most_contradiction};
  // Runs that it was joined to before stay joined to it; only that it seems to lie beside them once more is wrong.
  if (!joined_.contains(worst->first)) elsewhere_.insert(worst->first);
  for (const Edge& stitch : held_)
    if (!joined_.contains(stitch.id.a.experience)) elsewhere_.insert(stitch.id.a.experience);
  held_.clear();
  part();
  return refusal;
}

std::vector<Edge> HeldStitches::proven(double driven_m) {
  if (held_.empty()) return {};
  is_proven_ = is_proven_ || beside_m_ > config_.proven_m;
  const bool has_parted = driven_m - near_m_ > config_.parted_m;
  if (!is_proven_ && !has_parted) return {};
  std::vector<Edge> all = rest();
  if (has_parted) part();
  return all;
}

std::vector<Edge> HeldStitches::rest() {
  for (const Edge& stitch : held_) joined_.insert(stitch.id.a.experience);
  return std::exchange(held_, {});
}

/// Begins anew: where the run comes upon others again, that is to be proven again.
void HeldStitches::part() {
  contradictions_.clear();
  beside_m_ = 0.0;
  is_proven_ = false;
}

std::optional<PlaceId> HeldStitches::beside() const {
  return held_.empty() ? std::nullopt : std::optional(held_.back().id.a);
}

}  // namespace weft::agents
