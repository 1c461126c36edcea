#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "server/traffic/plan/lanes.hpp"
#include "server/traffic/plan/meetings.hpp"
#include "server/traffic/plan/move_choice.hpp"
#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/occupied_berths.hpp"
#include "server/traffic/plan/pocket_turns.hpp"
#include "server/traffic/plan/pockets.hpp"
#include "server/traffic/plan/robot_in_step.hpp"
#include "server/traffic/plan/safe_states.hpp"
#include "server/traffic/plan/wished_berths.hpp"

namespace weft::server {

/// Makes a plan as `plan_moves` does, a piece at a time. The plan does not depend on how it is divided. Between the
/// pieces nothing may change the graph: no map is followed, and no berth gets a number, but by these searches.
class MoveSteps {
 public:
  MoveSteps(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
            const PlanRules& rules);

  /// Goes on until so much is done, at most what one robot decides beyond that; at least a little. Returns whether
  /// the plan is complete. The unit is what one robot decides, or one search over some berths.
  bool work(std::uint64_t most);
  /// Returns the plan, which is complete.
  MovePlan take();
  /// Returns what was done so far; only differences mean anything.
  std::uint64_t done() const;

 private:
  /// Names what comes next in a step of the plan.
  enum class Part : std::uint8_t { begin, decide, check };
  /// Says what of others' wishes a wish keeps off: all that they drive through, or only where they want to stand. Who
  /// has to make way and cannot but into the way of who asks is asked again there.
  enum class Care : std::uint8_t { off_all_ways, off_where_they_end };

  // move_steps.cpp: the order of things
  void go_on();
  void begin_step();
  void decide();
  void begin_to_check();
  void check();
  void move_all();
  void look_at_pockets();
  void forget_asked(std::size_t first);
  bool goes_before(std::uint32_t a, std::uint32_t b) const;
  /// Returns whether the robot is being led away: it drives on before all others.
  bool is_led(std::uint32_t robot) const { return states_[robot].led < states_[robot].robot.led_over.size(); }
  bool is_sent_first(std::uint32_t robot) const;
  bool is_sent_on(std::uint32_t robot) const;
  bool is_safe(std::uint32_t robot);
  bool can_leave_for_others(std::uint32_t robot);
  bool is_there(std::uint32_t robot) const {
    return states_[robot].drives == 0 && states_[robot].robot.at != kNoBerth;
  }
  void move(std::uint32_t robot, std::uint32_t step);
  bool is_at_goal(std::uint32_t robot) const;
  void arrive(std::uint32_t robot, std::uint32_t handles) {
    states_[robot].robot.goal = nullptr;
    states_[robot].handles = handles;
  }
  void get_on(std::uint32_t robot);

  // move_wishes.cpp: what a robot wishes in a step
  bool wish(std::uint32_t robot, std::uint32_t asker);
  bool choose(std::uint32_t robot, std::uint32_t asker);
  bool would_keep_from(std::uint32_t robot, const PlanRobot& there, const Meeting& other);
  template <class IsOut>
  const BerthArc* way_out(std::uint32_t robot, IsOut&& is_out);
  template <class IsOut>
  bool clears(std::uint32_t robot, IsOut&& is_out);
  bool is_closed(std::uint32_t robot, const BerthArc& arc);
  bool is_led_on(std::uint32_t robot);
  bool goes(std::uint32_t robot, std::uint32_t asker);
  std::vector<MoveChoice> choices(std::uint32_t robot, std::uint32_t asker);
  bool set_off(std::uint32_t robot, const BerthArc& arc, Care care);
  bool would_meet(std::uint32_t robot, const BerthArc& arc);
  void note_met(std::uint32_t robot, std::uint32_t other, Berth to);
  /// Notes who keeps the robot where it stands at first, from where it wants to go most.
  void note_kept(std::uint32_t robot, std::uint32_t other) {
    if (!states_[robot].is_kept_known) states_[robot].kept_by.push_back(other);
  }
  std::uint32_t hinderer(std::uint32_t robot, const BerthArc& arc, Care care);
  void stay(std::uint32_t robot);
  void put_wish(std::uint32_t robot, const BerthArc* arc);
  void take_back_wish(std::uint32_t robot);
  void forget_wish(std::uint32_t robot);

  BerthGraph& graph_;
  Pockets& pockets_;
  Lanes& lanes_;
  PocketTurns turns_;
  Meetings meetings_;
  SafeStates safe_;
  PlanRules rules_;
  std::vector<RobotInStep> states_;
  std::uint32_t step_ = 0;
  Part part_ = Part::begin;
  std::size_t next_ = 0;                ///< in `order_` or `moving_`, by part
  std::uint64_t decisions_ = 0;         ///< and what counts as such
  std::vector<std::uint32_t> order_;    ///< in which robots decide
  std::vector<std::uint32_t> decided_;  ///< who has a wish in this step, in the order in which it was decided
  std::vector<std::uint32_t> moving_;
  OccupiedBerths occupied_;
  WishedBerths wished_;
  MovePlan plan_;
};

}  // namespace weft::server
