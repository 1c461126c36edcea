#pragma once
#include <cstdint>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/by_berth.hpp"
#include "server/traffic/plan/lanes.hpp"
#include "server/traffic/plan/occupied_arcs.hpp"

namespace weft::server {

/// Keeps where robots stand, or wish to, and refuses what would leave several of them stuck among one another. A
/// state is safe if all can get away one after another, each past those that have not yet, as in the banker's
/// algorithm (Dijkstra, EWD 623, 1977); that they find room elsewhere is taken for granted. Unlike `Lanes::meet` it
/// sees that three robots before a crossing block a fourth.
class SafeStates {
 public:
  SafeStates(BerthGraph& graph, Lanes& lanes) : graph_(graph), arcs_(graph), lanes_(lanes) {}

  /// Adds a robot, with the next number; one without a berth is nowhere. Those that are gridlocked are not asked
  /// whether they get away when one of them moves that gets half as far itself: nobody would, ever.
  void add(const Lanes::Stand& at, bool is_gridlocked = false);
  /// Notes that the robot is there now.
  void put(std::uint32_t robot, Berth at);
  /// Returns the robots that could no longer get away if the robot went there and can while it is where it is, in
  /// order of their numbers. Leaves out those of `leaving`. Adds those that block its ways if it would be stuck
  /// alone.
  std::vector<std::uint32_t> stuck_by(std::uint32_t robot, Berth to, const std::vector<std::uint32_t>& leaving);
  /// Returns the robots that keep this one from going there: those that would come face to face with it or could no
  /// longer get away, and are in no such trouble now. The robot itself may be among them. Two that are gridlocked do
  /// not keep each other from moving, as the plan that they are to follow knows of both.
  std::vector<std::uint32_t> kept_by(std::uint32_t robot, Berth to);
  /// Returns whether it can matter to one of them where the other stands: a way out of the one leads by there.
  bool concern(std::uint32_t robot, Berth to, const Lanes::Stand& other);
  /// Returns the berths over which the robot drives away past all others where they stand, in order: so many at most,
  /// to where nobody is stuck by it. Empty: it does not get away.
  std::vector<Berth> way_out(std::uint32_t robot, std::size_t most);
  /// Returns whether the robot can drive over these berths past all others where they stand, and nobody is stuck when
  /// it stands at the last.
  bool is_way_out(std::uint32_t robot, const std::vector<Berth>& over);
  Berth at(std::uint32_t robot) const { return robots_[robot].berth; }
  /// Counts searches for ways out, which bound the work of a piece.
  std::uint64_t searches() const { return searches_; }

 private:
  /// Tells how far a robot gets: away; of one that is gridlocked, half as far; or it is shut in.
  enum class Gets : std::uint8_t { nowhere, on, away };
  /// Remembers ways on which a robot gets away: what may not be taken for that.
  struct WaysOut {
    bool is_known = false;
    std::vector<bool> touched;  ///< by berth
  };

  class OthersOnly;

  std::vector<std::uint32_t> with_blockers(std::uint32_t robot, Berth to);
  std::vector<std::uint32_t> newly_stuck(std::uint32_t robot, Berth to);
  std::vector<std::uint32_t> stuck_around(std::vector<std::uint32_t> robots);
  void place(std::uint32_t robot, Berth at);
  void forget_ways_over(Berth berth);
  void set_away(std::uint32_t robot, bool is_away);
  void look(std::uint32_t robot);
  bool leaves(std::uint32_t robot, std::vector<std::uint32_t>& away);
  std::vector<std::uint32_t> concerned(std::uint32_t by, Berth berth) const;
  bool gets_away(std::uint32_t robot, std::vector<bool>* touched, std::vector<Berth>* blocked_at = nullptr);
  bool leaves_after_others(std::uint32_t robot, std::vector<std::uint32_t>& away, std::vector<bool>& is_tried);
  bool is_at_any(const std::vector<Berth>& berths, Berth at);
  Gets gets_from(std::uint32_t robot, Berth to);

  BerthGraph& graph_;
  OccupiedArcs arcs_;  ///< by those that are not away
  Lanes& lanes_;
  std::vector<Lanes::Stand> robots_;
  std::vector<WaysOut> ways_out_;  ///< of each robot, past all others where they are
  std::vector<bool> is_gridlocked_;
  std::vector<bool> is_away_;    ///< of each robot, while stuck ones are looked for
  Berth taken_ = kNoBerth;       ///< where one is thought to go meanwhile
  ByBerth<std::uint32_t> seen_;  ///< in which search
  ByBerth<Berth> from_;          ///< the berth before it in the latest search
  std::vector<Berth> reached_;   ///< by the latest search
  std::uint32_t searches_ = 0;
};

}  // namespace weft::server
