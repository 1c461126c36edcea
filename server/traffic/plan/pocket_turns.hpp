#pragma once
#include <cstdint>
#include <vector>

#include "server/traffic/plan/move_plan.hpp"
#include "server/traffic/plan/pockets.hpp"

namespace weft::server {

/// Decides in each step of the plan who may go into which pocket: one robot at a time, and one that goes there. A
/// robot that finds it taken does not wait in its mouth.
class PocketTurns {
 public:
  explicit PocketTurns(Pockets& pockets)
      : pockets_(pockets), owner_(pockets.size(), kNobody), wanted_by_(pockets.size()) {}

  struct Wanting {
    std::uint32_t robot = kNobody;
    const PlanRobot* known = nullptr;
  };

  void begin_step();
  /// Notes that the robot is at that berth, or drives through it yet.
  void is_at(Berth berth, std::uint32_t robot);
  /// Notes where the robot wants to go, which is described by `known` for all of the step.
  void wants(std::uint32_t robot, const PlanRobot& known);
  /// Returns the robots that want to go into the pocket and are not in it.
  const std::vector<Wanting>& wanted_by(std::uint32_t pocket) const { return wanted_by_[pocket]; }

  /// Returns whether the robot may go there: one that is to wait does so before the mouth, unless it has to make way.
  /// A robot that makes way may go into a pocket that nobody wants, and through any from which it has no other way
  /// on.
  bool may_go(std::uint32_t robot, const PlanRobot& known, Berth to, bool is_asked) const;
  /// Returns whether the drive there leads into a pocket.
  bool leads_in(const PlanRobot& known, Berth to) const;
  /// Returns the robot in the pocket that keeps this one from going there; kNobody: none does.
  std::uint32_t keeper(std::uint32_t robot, const PlanRobot& known, Berth to) const;
  /// Returns whether the robot stands in the mouth of a pocket in which it wants to go, and which is taken.
  bool is_refused(std::uint32_t robot, const PlanRobot& known) const;
  /// Returns whether the robot has nothing to do and stands in the mouth of a pocket to which another one comes:
  /// there is no room to ask it on from there once that one has come.
  bool is_in_a_mouth(const PlanRobot& known) const;

  /// Takes the pocket in which the berth lies for the robot. Returns whether there is one that nobody had.
  bool take(Berth berth, std::uint32_t robot);
  void give_back(Berth berth) { owner_[pockets_.of(berth)] = kNobody; }

 private:
  bool is_open(std::uint32_t pocket, std::uint32_t robot) const {
    return owner_[pocket] == kNobody || owner_[pocket] == robot;
  }
  bool is_near_mouth(const PlanRobot& known, std::uint32_t pocket) const;

  Pockets& pockets_;
  std::vector<std::uint32_t> owner_;             ///< of each pocket: the robot that is in it, or goes there
  std::vector<std::vector<Wanting>> wanted_by_;  ///< of each pocket
};

}  // namespace weft::server
