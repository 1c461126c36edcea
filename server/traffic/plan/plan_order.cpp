#include "server/traffic/plan/plan_order.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace weft::server {

PlanOrder::PlanOrder(MovePlan plan) : plan_(std::move(plan)), released_(plan_.moves.size(), 0) {
  for (std::uint32_t robot = 0; robot < plan_.moves.size(); ++robot) {
    std::uint32_t number = 0;
    for (const PlannedMove& move : plan_.moves[robot]) {
      const Visit visit{move.step, robot, number++};
      ends_.at(move.arc->to).push_back(visit);
      ends_.at(move.arc->middle).push_back(visit);
      for (const Berth berth : move.arc->touches) passes_.at(berth).push_back(visit);
    }
  }
}

/// Returns whether `test` holds for any visit of another robot that meets this move.
template <class Test>
bool PlanOrder::any_meets(std::uint32_t robot, std::uint32_t move, Test&& test) const {
  const auto any = [&](const Visits& visits, Berth berth) {
    const std::vector<Visit>* const found = visits.find(berth);
    return found != nullptr && std::any_of(found->begin(), found->end(),
                                           [&](const Visit& other) { return other.robot != robot && test(other); });
  };
  const BerthArc& arc = *plan_.moves[robot][move].arc;
  return any(passes_, arc.to) || any(passes_, arc.middle) ||
         std::any_of(arc.touches.begin(), arc.touches.end(), [&](Berth berth) { return any(ends_, berth); });
}

bool PlanOrder::is_shared(std::uint32_t robot, std::uint32_t move) const {
  return any_meets(robot, move, [](const Visit& /*other*/) { return true; });
}

/// Returns who has to have made moves before the robot's next one.
std::vector<std::uint32_t> PlanOrder::before(std::uint32_t robot) const {
  const std::uint32_t next = released_[robot];
  if (next >= plan_.moves[robot].size()) return {};
  std::set<std::uint32_t> first;
  any_meets(robot, next, [&](const Visit& other) {
    const bool is_first = other.step < plan_.moves[robot][next].step && other.move >= released_[other.robot];
    if (is_first) first.insert(other.robot);
    return false;
  });
  for (const MovesFirst& other : plan_.moves[robot][next].first) {
    if (released_[other.robot] < other.moves) first.insert(other.robot);
  }
  return {first.begin(), first.end()};
}

std::vector<std::uint32_t> PlanOrder::waits_for(std::uint32_t robot) const {
  const std::vector<std::uint32_t> first = before(robot);
  if (!first.empty()) return first;
  const std::set<std::uint32_t> others(plan_.kept_by[robot].begin(), plan_.kept_by[robot].end());
  return {others.begin(), others.end()};
}

std::uint32_t PlanOrder::may(std::uint32_t robot) const {
  const std::vector<PlannedMove>& moves = plan_.moves[robot];
  std::uint32_t number = released_[robot];
  for (; number < moves.size(); ++number) {
    const auto comes_first = [&](const Visit& other) {
      return other.step < moves[number].step && other.move >= released_[other.robot];
    };
    const bool has_to_wait =
        std::any_of(moves[number].first.begin(), moves[number].first.end(),
                    [this](const MovesFirst& other) { return released_[other.robot] < other.moves; });
    if (has_to_wait || any_meets(robot, number, comes_first)) break;
  }
  return number;
}

}  // namespace weft::server
