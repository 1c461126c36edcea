#pragma once
#include "core/random.hpp"
#include "tests/simulation/fleet.hpp"

namespace weft::simulation {

/// Draws faults from a seed and plays them beside whatever else happens: a lossy network all the time; crashes,
/// processes that stand still, links cut both ways or one way, changed addresses, strangers, full disks and failing
/// writes now and then, several at once.
class Chaos {
 public:
  Chaos(Fleet& fleet, Random random);

  /// Sets faults of the network only, all of them rare.
  void mild();
  void full();
  /// Ends all faults: everything heals and comes up again.
  void over();
  /// Plays what is due; to be called every few simulated seconds.
  void play();
  std::uint64_t played() const { return played_; }

 private:
  enum class Kind {
    crash_server,
    crash_robot,
    cut_robot,
    cut_one_way,
    disk_full,
    writes_fail,
    torn_write,
    hang_server,
    hang_robot,
    stray_server,
    robot_disk_full,
    move_server,
    move_robot,
    kinds
  };
  Kind draw() { return static_cast<Kind>(random_.below(static_cast<std::uint64_t>(Kind::kinds))); }
  void begin(Kind kind);
  void begin_at(std::size_t robot, Kind kind);
  void heal_due();
  SteadyTime soon(double mean_s);

  Fleet& fleet_;
  Random random_;
  bool on_ = false;
  SteadyTime next_{};
  std::optional<SteadyTime> server_back_;
  std::optional<SteadyTime> disk_back_;
  std::optional<SteadyTime> server_wakes_;
  std::optional<SteadyTime> stray_gone_;
  std::vector<std::optional<SteadyTime>> robot_wakes_;
  std::vector<std::optional<SteadyTime>> robot_back_;
  std::vector<std::optional<SteadyTime>> link_back_;
  std::vector<std::optional<SteadyTime>> spool_back_;
  std::uint64_t played_ = 0;
};

}  // namespace weft::simulation
