#pragma once
#include <cstdint>
#include <vector>

#include "server/traffic/plan/by_berth.hpp"
#include "server/traffic/plan/move_plan.hpp"

namespace weft::server {

/// Keeps the order of a plan while it is driven: no robot is released to where another one comes earlier in the plan
/// and has not been released yet. Does not look at what others hold: leases do that.
class PlanOrder {
 public:
  PlanOrder() = default;
  explicit PlanOrder(MovePlan plan);

  const std::vector<PlannedMove>& moves(std::uint32_t robot) const { return plan_.moves[robot]; }
  /// Returns how many of the robot's planned moves may be released now, those included that have been.
  std::uint32_t may(std::uint32_t robot) const;
  /// Returns the robots that this one waits for: those that have to pass where its next move leads, or to leave a
  /// lane, or else those that keep it where it stands. Sorted.
  std::vector<std::uint32_t> waits_for(std::uint32_t robot) const;
  /// Returns whether another robot comes by in this plan, before or after.
  bool is_shared(std::uint32_t robot, std::uint32_t move) const;
  std::uint32_t released(std::uint32_t robot) const { return released_[robot]; }
  /// Notes that so many of the robot's moves are released.
  void release(std::uint32_t robot, std::uint32_t moves) { released_[robot] = moves; }

 private:
  struct Visit {
    std::uint32_t step = 0;
    std::uint32_t robot = 0;
    std::uint32_t move = 0;
  };
  using Visits = ByBerth<std::vector<Visit>>;

  std::vector<std::uint32_t> before(std::uint32_t robot) const;
  template <class Test>
  bool any_meets(std::uint32_t robot, std::uint32_t move, Test&& test) const;

  MovePlan plan_;
  std::vector<std::uint32_t> released_;
  Visits ends_;    ///< by the berth to which a move leads
  Visits passes_;  ///< by each that it touches
};

}  // namespace weft::server
