#include "agents/methods/topometric/plan.hpp"

#include <numbers>
#include <utility>

namespace weft::agents {
namespace {

Planned on_the_way(PlanMode mode, PlanEffect effect) {
  return {{mode, std::nullopt, false}, effect};
}

/// Clears the costmap first, then looks around, and stands in the end (III-D: the recovery behaviour).
Planned recovering(const PlanConfig& config, PlanState state, double turned_rad) {
  state.mode = PlanMode::lost;
  if (!std::exchange(state.has_cleared, true)) return {state, PlanEffect::clear_costmap};
  const double most_rad = 2.0 * std::numbers::pi * config.recover_turns;
  return {state, turned_rad < most_rad ? PlanEffect::look_around : PlanEffect::stand};
}

bool waits_too_long(const PlanConfig& config, PlanState& state, SensorTime now) {
  if (!state.no_plan_since) state.no_plan_since = now;
  return now - *state.no_plan_since >= from_seconds(config.no_plan_s);
}

/// Stands before what is in the way. It may be there no more: after a while the costmap forgets it once. Waiting on
/// is traffic's business (contract, T6).
Planned blocked(const PlanConfig& config, PlanState state, SensorTime now) {
  if (waits_too_long(config, state, now) && !std::exchange(state.has_cleared, true))
    return {state, PlanEffect::clear_costmap};
  return {state, PlanEffect::stand};
}

}  // namespace

Planned plan_next(const PlanConfig& config, const PlanState& state, PlanEvent event, SensorTime now,
                  double turned_rad) {
  const bool is_lost = state.mode == PlanMode::lost;
  switch (event) {
    case PlanEvent::is_lost:
      return recovering(config, state, turned_rad);
    case PlanEvent::is_found:
    case PlanEvent::arrived:
      return on_the_way(PlanMode::generate_global_plan, PlanEffect::plan_globally);
    case PlanEvent::has_local_goal:
      if (is_lost) return on_the_way(PlanMode::generate_global_plan, PlanEffect::plan_globally);
      return on_the_way(PlanMode::execute_local_plan, PlanEffect::drive);
    case PlanEvent::chart_ends:
      if (is_lost) return on_the_way(PlanMode::generate_global_plan, PlanEffect::plan_globally);
      return on_the_way(PlanMode::switch_pending, PlanEffect::drive_slowly);
    case PlanEvent::is_blocked:
      return blocked(config, state, now);
    case PlanEvent::has_no_way: {
      PlanState waiting = state;
      if (is_lost || waits_too_long(config, waiting, now)) return recovering(config, waiting, turned_rad);
      return {waiting, PlanEffect::stand};
    }
  }
  return {state, PlanEffect::stand};
}

}  // namespace weft::agents
