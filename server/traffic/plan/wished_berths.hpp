#pragma once
#include <cstdint>
#include <vector>

#include "server/traffic/plan/by_berth.hpp"
#include "server/traffic/plan/move_plan.hpp"

namespace weft::server {

/// Keeps where robots wish to be when a step of the plan ends, and what they drive through for that.
class WishedBerths {
 public:
  /// Returns who wishes to stand there, or to be in the middle of that drive; kNobody: nobody does.
  std::uint32_t who_wishes(Berth berth) { return wished_.at(berth).robot; }
  /// Returns who else touches the end of that drive, or its middle, by its wish; kNobody: nobody does.
  std::uint32_t who_touches(const BerthArc& arc, std::uint32_t robot);
  /// Notes that the robot wishes to stay; `beside`: at which berths nobody can stand then.
  void stay(Berth here, const std::vector<Berth>& beside, std::uint32_t robot);
  /// Notes that the robot wishes to make that drive.
  void drive(const BerthArc& arc, std::uint32_t robot);
  /// Takes that back.
  void take_back(const BerthArc& arc, std::uint32_t robot);
  /// Forgets that the robot wishes to stay, also while others' wishes are kept.
  void forget_stay(Berth here, const std::vector<Berth>& beside, std::uint32_t robot);
  /// Forgets a wish as the step ends, when all are forgotten.
  void forget_drive(const BerthArc& arc);

 private:
  struct Wished {
    std::uint32_t robot = kNobody;
  };

  ByBerth<Wished> wished_;
  ByBerth<std::vector<std::uint32_t>> touched_by_;  ///< whose wish touches it
};

}  // namespace weft::server
