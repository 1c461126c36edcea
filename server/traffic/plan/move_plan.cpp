#include "server/traffic/plan/move_plan.hpp"

#include <algorithm>
#include <limits>

#include "server/traffic/plan/move_steps.hpp"

namespace weft::server {

MovePlan plan_moves(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
                    const PlanRules& rules) {
  MoveSteps steps(graph, pockets, lanes, robots, rules);
  steps.work(std::numeric_limits<std::uint64_t>::max());
  return steps.take();
}

bool leads_away(BerthGraph& graph, Berth from, std::span<const PlannedMove> moves) {
  if (moves.empty()) return false;  // from nowhere, too, where the map has no such place any more
  const std::vector<Berth>& beside = graph.beside(from);
  return std::any_of(moves.begin(), moves.end(), [&](const PlannedMove& move) {
    return move.arc->to != from && !std::binary_search(beside.begin(), beside.end(), move.arc->to);
  });
}

}  // namespace weft::server
