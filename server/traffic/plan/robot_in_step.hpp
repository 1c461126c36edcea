#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "server/traffic/plan/meetings.hpp"
#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/pockets.hpp"

namespace weft::server {

/// Describes a robot in a step of the plan.
struct RobotInStep {
  PlanRobot robot;
  std::uint32_t drives = 0;   ///< steps until it is at the end of what it was released
  std::uint32_t handles = 0;  ///< steps for which it cannot be asked
  const BerthArc* wish = nullptr;
  bool has_wish = false;               ///< of this step; without an arc: to stay
  bool is_asking = false;              ///< it, or whom it asked, is being decided
  std::uint32_t in = Pockets::kNone;   ///< the pocket where it stands
  bool leaves = false;                 ///< that pocket
  std::size_t led = 0;                 ///< how many of the berths it has driven over which it is led away
  std::vector<MovesFirst> first;       ///< robots that have to leave a lane before it makes its move
  std::vector<std::uint32_t> kept_by;  ///< see MovePlan
  bool is_kept_known = false;          ///< `kept_by` is complete
  std::vector<std::uint32_t> met;      ///< robots in the lane where it wants to go, or that cannot make way
  std::optional<Meeting> sent_on;      ///< it keeps that one from going there, and may be sent on
  std::uint32_t sent_in = 0;           ///< the step in which that was found
  bool has_way_out = false;  ///< it can drive out of that one's way, be that free or not, when the plan begins
};

}  // namespace weft::server
