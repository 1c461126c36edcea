#include "server/traffic/plan/move_plan.hpp"

#include <limits>

#include "server/traffic/plan/move_steps.hpp"

namespace weft::server {

MovePlan plan_moves(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
                    const PlanRules& rules) {
  MoveSteps steps(graph, pockets, lanes, robots, rules);
  steps.work(std::numeric_limits<std::uint64_t>::max());
  return steps.take();
}

}  // namespace weft::server
