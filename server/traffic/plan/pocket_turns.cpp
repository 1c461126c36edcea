#include "server/traffic/plan/pocket_turns.hpp"

#include <algorithm>

namespace weft::server {
namespace {
/// Bounds how far before the mouth of a pocket a robot is on its way into it, for others that stand there.
constexpr double kNearMouth_m = 15.0;
}  // namespace

void PocketTurns::begin_step() {
  std::fill(owner_.begin(), owner_.end(), kNobody);
  for (std::vector<Wanting>& robots : wanted_by_) robots.clear();
}

void PocketTurns::is_at(Berth berth, std::uint32_t robot) {
  const std::uint32_t pocket = pockets_.of(berth);
  if (pocket != Pockets::kNone) owner_[pocket] = robot;
}

void PocketTurns::wants(std::uint32_t robot, const PlanRobot& known) {
  const bool wants_in = known.goal != nullptr && known.pocket != Pockets::kNone;
  if (wants_in && pockets_.of(known.at) != known.pocket) wanted_by_[known.pocket].push_back({robot, &known});
}

bool PocketTurns::is_refused(std::uint32_t robot, const PlanRobot& known) const {
  if (known.goal == nullptr || known.pocket == Pockets::kNone || pockets_.of(known.at) == known.pocket) return false;
  return pockets_.is_at_mouth(known.pocket, known.at) && !is_open(known.pocket, robot);
}

bool PocketTurns::is_in_a_mouth(const PlanRobot& known) const {
  if (known.goal != nullptr) return false;
  for (std::uint32_t pocket = 0; pocket < wanted_by_.size(); ++pocket) {
    if (wanted_by_[pocket].empty() || !pockets_.is_at_mouth(pocket, known.at)) continue;
    const auto comes = [&](const Wanting& other) { return is_near_mouth(*other.known, pocket); };
    if (std::any_of(wanted_by_[pocket].begin(), wanted_by_[pocket].end(), comes)) return true;
  }
  return false;
}

bool PocketTurns::is_near_mouth(const PlanRobot& known, std::uint32_t pocket) const {
  double mouth_m = Distances::kFar_m;
  for (const Berth berth : pockets_.at_mouth(pocket)) mouth_m = std::min(mouth_m, known.goal->from_m(berth));
  return known.goal->from_m(known.at) <= mouth_m + kNearMouth_m;
}

bool PocketTurns::may_go(std::uint32_t robot, const PlanRobot& known, Berth to, bool is_asked) const {
  const std::uint32_t in = pockets_.of(known.at);
  const std::uint32_t pocket = pockets_.of(to);
  const bool wants_in = known.goal != nullptr && known.pocket != Pockets::kNone;
  if (pocket != Pockets::kNone && pocket != in) {
    // A goal may lie inside what was found to be a pocket from elsewhere alone.
    const bool may_want_in = known.goal != nullptr && !wants_in && !is_asked;
    const bool may_step_in = is_asked && wanted_by_[pocket].empty();
    // One without a goal that has no other way on would stand in the mouth for ever.
    const bool has_to_go_through = known.goal == nullptr && pockets_.leads_only_into(pocket, known.at, known.methods);
    return (may_want_in || may_step_in || has_to_go_through || (wants_in && known.pocket == pocket)) &&
           is_open(pocket, robot);
  }
  const bool would_wait = wants_in && in != known.pocket && !is_open(known.pocket, robot);
  return is_asked || !would_wait || !pockets_.is_at_mouth(known.pocket, to) ||
         pockets_.is_at_mouth(known.pocket, known.at);
}

bool PocketTurns::leads_in(const PlanRobot& known, Berth to) const {
  const std::uint32_t pocket = pockets_.of(to);
  return pocket != Pockets::kNone && pocket != pockets_.of(known.at);
}

std::uint32_t PocketTurns::keeper(std::uint32_t robot, const PlanRobot& known, Berth to) const {
  const std::uint32_t inside = pockets_.of(to);
  const std::uint32_t pocket = inside != Pockets::kNone ? inside : known.pocket;
  return pocket != Pockets::kNone && !is_open(pocket, robot) ? owner_[pocket] : kNobody;
}

bool PocketTurns::take(Berth berth, std::uint32_t robot) {
  const std::uint32_t pocket = pockets_.of(berth);
  if (pocket == Pockets::kNone || owner_[pocket] != kNobody) return false;
  owner_[pocket] = robot;
  return true;
}

}  // namespace weft::server
