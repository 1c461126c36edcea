#pragma once
#include <vector>

#include "server/traffic/plan/move_plan.hpp"

namespace weft::server {

/// Returns of each robot whether it is gridlocked: by the plan it does not move, nor does any of those that keep it,
/// though each of them could be asked to. Robots that nobody is kept by are not counted.
std::vector<bool> gridlocked(const MovePlan& plan, const std::vector<PlanRobot>& robots);

/// Returns whether a robot that has a goal, and is none of `some`, stands because of one of these, or of whom they
/// keep.
bool keep_others(const MovePlan& plan, const std::vector<PlanRobot>& robots, const std::vector<bool>& some);

}  // namespace weft::server
