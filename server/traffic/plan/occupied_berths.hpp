#pragma once
#include <cstdint>
#include <map>

#include "server/traffic/plan/by_berth.hpp"
#include "server/traffic/plan/move_plan.hpp"

namespace weft::server {

/// Keeps which berths robots occupy in a step of the plan: where they stand, what they drive through yet, and where
/// those go that move in it.
class OccupiedBerths {
 public:
  /// Returns the robot that stands there as the step begins; kNobody: none does.
  std::uint32_t who_stands_at(Berth berth) { return standing_.at(berth).robot; }
  void stand(Berth berth, std::uint32_t robot) { standing_.at(berth).robot = robot; }
  void leave(Berth berth) { standing_.at(berth).robot = kNobody; }
  /// Notes that the robot has that berth behind it, which it leaves later; it may have one several times.
  void drive_through(Berth berth, std::uint32_t robot) { ++behind_.at(berth)[robot]; }
  void have_driven_through(Berth berth, std::uint32_t robot);
  /// Returns who else holds something on that drive as the step begins; kNobody: nobody does.
  std::uint32_t occupant(const BerthArc& arc, std::uint32_t robot);
  /// Notes that somebody makes that drive in the step.
  void move(const BerthArc& arc, std::uint32_t step);
  /// Returns whether nobody who moves in this step comes by that drive.
  bool keeps_off_movers(const BerthArc& arc, std::uint32_t step);

 private:
  struct Standing {
    std::uint32_t robot = kNobody;
  };

  ByBerth<Standing> standing_;
  ByBerth<std::map<std::uint32_t, std::uint32_t>> behind_;  ///< who still drives through it, how often
  ByBerth<std::uint32_t> entered_;  ///< in which step, counted from one, somebody stands there
  ByBerth<std::uint32_t> passed_;   ///< and drives through
};

}  // namespace weft::server
