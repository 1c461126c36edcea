#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "server/traffic/waits.hpp"
#include "tests/bench/traffic/lanes.hpp"

namespace weft::bench {

/// Sets a robot's radius: a cell has room for it, also beside one that drives by. Lanes lie up to 0.25 m beside the
/// middles of cells, 1.2 m from a neighbour's; two robots need 1.16 m with slack and margin.
inline constexpr double kRadius_m = 0.28;
inline constexpr double kSpeed_m_s = 0.6;
inline constexpr double kStep_s = kCell_m / kSpeed_m_s;
inline constexpr double kDelayed = 0.02;  ///< share of steps in which a robot does not get on
inline constexpr int kHandling = 5;       ///< steps at a goal, about 12 s, in which a robot cannot be pushed

/// Describes a robot as a point that moves from cell to cell.
struct Robot {
  Cell at = 0;
  Cell goal = 0;
  int handles = 0;   ///< steps left at its goal
  int asked_at = 0;  ///< step at which it was given its goal
  int stands_since = 0;
};

/// Holds the robots that the policies drive: with goals without end, the same ones for all policies of a seed.
class Fleet {
 public:
  Fleet(const Network& network, std::uint32_t robots, std::uint64_t seed);

  const Network& network() const { return network_; }
  std::vector<Robot>& robots() { return robots_; }
  int now() const { return now_; }
  /// Returns how many steps it is from each cell to that one.
  const std::vector<std::uint32_t>& steps_to(Cell goal);
  bool is_delayed() { return delays_.uniform() < kDelayed; }
  /// Moves the robot, once in a step at most.
  void move(std::size_t robot, Cell to);
  /// Ends the step: a robot that has arrived handles its load, and gets its next goal afterwards.
  void end_step();

  std::uint64_t goals_done = 0;
  std::vector<int> waits;  ///< steps that robots stood for with a goal, each time
  int oldest = 0;          ///< steps that a goal has been under way, those included that still are

 private:
  Cell next_goal(std::size_t robot);

  const Network& network_;
  std::vector<Robot> robots_;
  std::vector<Random> goals_;  ///< of each robot: what it is asked does not depend on how it gets there
  Random delays_;
  int now_ = 0;
  std::map<Cell, std::vector<std::uint32_t>> steps_;
};

/// Tells how well one arrival was foretold half of the way there.
struct Foreseen {
  double error = 0.0;  ///< share of the time that it took from there
  bool is_in_band = false;
};

/// Decides who moves. Deterministic: the same fleet moves alike.
class Policy {
 public:
  virtual ~Policy() = default;
  /// Moves the robots of the fleet by one step.
  virtual void step() = 0;
  /// Returns which robots stand and wait for which.
  virtual std::vector<server::Wait> waits() = 0;
  /// Counts pairs of robots that hold what overlaps.
  virtual std::uint64_t overlaps() = 0;
  /// Returns how well it foretold arrivals; nothing of a policy that does not.
  virtual std::vector<Foreseen> foreseen() const { return {}; }
};

std::unique_ptr<Policy> make_whole(Fleet& fleet);             ///< today's rule, by the product's Traffic
std::unique_ptr<Policy> make_whole_asking_all(Fleet& fleet);  ///< the same, and all who wait ask at each report
std::unique_ptr<Policy> make_ours(Fleet& fleet);              ///< the product's plan, and leases in its order
std::unique_ptr<Policy> make_prioritised(Fleet& fleet);       ///< space-time A* robot by robot, 24 steps ahead
std::unique_ptr<Policy> make_bound(Fleet& fleet);             ///< PIBT with following, no delays: cannot be executed

RobotId fleet_robot_id(std::size_t robot);

}  // namespace weft::bench
