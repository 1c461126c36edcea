#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/safe_states.hpp"

namespace weft::server {

/// Returns of each robot whether it is gridlocked: by the plan it does not move, nor does any of those that keep it,
/// though each of them could be asked to. Robots that nobody is kept by are not counted.
std::vector<bool> gridlocked(const MovePlan& plan, const std::vector<PlanRobot>& robots);

/// Returns whether a robot that has a goal, and is none of `some`, stands because of one of these, or of whom they
/// keep.
bool keep_others(const MovePlan& plan, const std::vector<PlanRobot>& robots, const std::vector<bool>& some);

/// Names a robot and the berths over which it is led away from others, in order.
struct LedAway {
  std::uint32_t robot = kNobody;
  std::vector<Berth> over;
};

/// Returns which of the gridlocked robots is led away, its goal or not, past all others where they stand: as long as
/// all can get away one after another, one of them can do so first. `led_at` tells when each was led last, the lower
/// the longer ago. Of those that were never led, who keeps others goes first, and of these who has waited least. All
/// come by: what shuts in who keeps others may itself keep nobody by the plan. Nobody: none gets away.
LedAway led_away_of(SafeStates& states, const MovePlan& plan, const std::vector<PlanRobot>& robots,
                    const std::vector<bool>& locked, const std::function<std::uint64_t(std::uint32_t)>& led_at);

}  // namespace weft::server
