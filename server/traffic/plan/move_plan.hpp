#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/distances.hpp"
#include "server/traffic/plan/lanes.hpp"
#include "server/traffic/plan/meetings.hpp"
#include "server/traffic/plan/pockets.hpp"

namespace weft::server {

/// Is the number of no robot of a plan.
inline constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// Describes a robot to the plan.
struct PlanRobot {
  Berth at = kNoBerth;        ///< where what it was released ends
  std::vector<Berth> behind;  ///< what it drives through until it is there, in order; it leaves one a step
  std::uint32_t methods = 0;
  std::uint32_t pocket = Pockets::kNone;  ///< in which its goal lies
  Distances* goal = nullptr;              ///< to where it is going; null: nowhere, and it makes way if it is asked to
  bool is_goal_at_hand = true;            ///< `goal` leads to its goal, not only to a berth on the way there
  std::uint32_t handles = 0;              ///< steps for which it cannot be asked, as it is at work where it was going
  std::vector<Berth> avoids;              ///< it could not drive there
  bool stays = false;                     ///< it does not move by itself, and nobody can ask it to
  bool gives_way = false;                 ///< though it has a goal, to those that go before it and wait for it
  bool is_gridlocked = false;             ///< as others are; it may move though some of these cannot get away then
  std::uint8_t priority = 0;              ///< the larger, the more urgent
  double waits_s = 0.0;                   ///< since its goal was asked for
  std::vector<Berth> led_over;            ///< the berths over which it is led away, in order, its goal or not
  std::optional<Meeting> sent_on;         ///< it has nothing to do, and was found to keep that one from going there
};

/// Describes one drive from a berth to the next, begun in that step of the plan.
struct PlannedMove {
  const BerthArc* arc = nullptr;
  Berth from = kNoBerth;
  std::uint32_t step = 0;
  std::vector<MovesFirst> first;  ///< robots that have to leave a lane before
};

struct PlanRules {
  std::uint32_t steps = 30;    ///< of one berth each
  std::uint32_t handling = 5;  ///< steps for which a robot that comes to its goal cannot be asked to make way
};

/// Holds what everybody will do, in order of the steps; one list a robot, as they were given.
struct MovePlan {
  std::vector<std::vector<PlannedMove>> moves;
  std::vector<std::vector<std::uint32_t>> kept_by;  ///< of each, the robots that keep it where it stands at first
  std::vector<std::optional<Meeting>> sent_on;      ///< of each, whom it was found to keep from where, at last
  std::uint32_t to_make_way = 0;                    ///< robots in others' way when it begins that can drive out of it
  std::uint64_t pushes = 0;                         ///< robots that were asked to make way
  std::uint64_t asked_several = 0;                  ///< of these, together with others: there PIBT gives no guarantee
};

/// Plans some steps ahead for all robots: priority inheritance with backtracking (Okumura, Machida, Defago, Tamura,
/// "Priority inheritance with backtracking for iterative multi-agent path finding", AIJ 310, 2022), changed for what
/// is exclusively held. A robot enters a berth only if it and all beside it are empty when the step begins, so nobody
/// follows into what is left in that step, and robots in a circle do not rotate: a wish that would close a circle is
/// refused. A pocket takes one robot, and one that goes there; who leaves it goes first; who finds it taken does not
/// wait in its mouth. Nobody goes into a lane towards one that comes out of it. Deterministic: ties are broken by the
/// order in which the robots are given.
MovePlan plan_moves(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
                    const PlanRules& rules);

/// Returns whether the moves lead to where a robot no longer touches the berth at which they begin: who makes way by
/// others stays in the way.
bool leads_away(BerthGraph& graph, Berth from, std::span<const PlannedMove> moves);

}  // namespace weft::server
