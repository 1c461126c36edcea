#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "server/traffic/traffic.hpp"
#include "storage/map_store.hpp"
#include "tests/bench/traffic/fleet.hpp"
#include "tests/bench/traffic/taught_lanes.hpp"

namespace weft::bench {

/// Drives a fleet by the leases of the product's Traffic: robots drive what they are released, and say what they have
/// left. What is asked for is for policies to decide.
class Leased {
 public:
  explicit Leased(Fleet& fleet);

  struct Way {
    std::optional<Route> route;
    std::uint32_t at = 0;
    bool is_told = false;  ///< something of the route is released
    bool is_delayed = false;
    server::Traffic::Way said;
  };

  std::vector<Way>& ways() { return ways_; }
  const TaughtLanes& lanes() const { return lanes_; }
  server::Traffic& traffic() { return traffic_; }
  std::shared_ptr<const Snapshot> network() const { return writer_.snapshots().shared_current(); }

  /// Gives the robot a route that nothing of is released yet.
  void begin(std::size_t robot, Route route);
  /// Asks for the route as far as it is written down, and releases to the last of `stops`, indices in order, that can
  /// be had; none: to where it can be had.
  void release(std::size_t robot, const server::Traffic::Stops* stops);
  /// Takes the time of driving from one place to the next.
  void pass_tick();
  /// Drives the robot to the next place, if it was released that. Returns whether it has.
  bool drive(std::size_t robot);
  static std::size_t number(const RobotId& robot) { return robot.bytes[14] * 256U + robot.bytes[15]; }

  /// Returns which robots stand and wait for which.
  std::vector<server::Wait> waits();
  /// Counts pairs of robots that hold what overlaps, by where the places truly lie.
  std::uint64_t overlaps();

 private:
  server::Now now() const { return {.steady = clock_, .wall = WallTime(clock_.time_since_epoch())}; }
  std::map<RobotId, storage::PutOccupancy> standing() const;

  Fleet& fleet_;
  TaughtLanes lanes_;
  SteadyTime clock_{std::chrono::seconds(1000)};
  server::ServiceConfig config_;
  server::Counters counters_;
  std::unique_ptr<storage::MapStore> store_;
  server::Outbox out_;
  server::MapWriter writer_;
  server::Maintenance maintenance_;
  server::Context context_;
  server::Traffic traffic_;
  std::vector<Way> ways_;
  std::uint64_t routes_ = 0;
};

}  // namespace weft::bench
