#pragma once
#include <cstdint>
#include <optional>

#include "core/time.hpp"

/// Decides what a robot on its way does next (Dayoub et al. 2013, III-D, fig. 5): (state, event, time) -> (state,
/// effect), pure. The paper's global Dijkstra is the server's route here.
namespace weft::agents {

struct PlanConfig {
  double pending_m = 1.5;      ///< a local goal nearer than this asks for the next chart; (0, 10]
  double pending_m_s = 0.2;    ///< no faster while it is missing; (0, 2]
  double no_plan_s = 5.0;      ///< without a local plan it is lost; (0, 60]
  double recover_turns = 2.0;  ///< whole turns on the spot at most; [0, 5]
  double recover_rad_s = 0.5;  ///< (0, 3]
};

enum class PlanMode : std::uint8_t {
  generate_global_plan,  ///< it knows where it is, and has no way to go
  execute_local_plan,    ///< it drives to the last place of its route that the chart knows
  switch_pending,        ///< it comes to the end of what the chart knows, and the next one is missing
  lost
};

/// Tells what a look at chart, route and belief has shown.
enum class PlanEvent : std::uint8_t {
  has_local_goal,  ///< a way leads to a local goal in the chart
  chart_ends,      ///< the local goal is near, and beyond it the chart knows nothing
  arrived,         ///< at the end of the way
  is_blocked,      ///< something stands in the way that the chart does not know
  has_no_way,      ///< the chart knows no way to any local goal
  is_lost,         ///< blind for too long, or views contradict the belief
  is_found         ///< it knows again where it is
};

enum class PlanEffect : std::uint8_t {
  plan_globally,  ///< stand until there is a way
  drive,
  drive_slowly,
  stand,
  clear_costmap,  ///< and stand: what it remembers may be what is in the way
  look_around     ///< turn on the spot, never drive
};

struct PlanState {
  PlanMode mode = PlanMode::generate_global_plan;
  std::optional<SensorTime> no_plan_since;
  bool has_cleared = false;  ///< the costmap, since it was last on its way
};

struct Planned {
  PlanState state;
  PlanEffect effect = PlanEffect::stand;
};

/// Takes an event. `turned_rad`: so much it has turned on the spot since it was lost.
Planned plan_next(const PlanConfig& config, const PlanState& state, PlanEvent event, SensorTime now,
                  double turned_rad = 0.0);

}  // namespace weft::agents
