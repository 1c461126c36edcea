#pragma once
#include <cstdint>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/by_berth.hpp"
#include "server/traffic/plan/lanes.hpp"

namespace weft::server {

/// Names a robot that has to have made so many of its planned moves first.
struct MovesFirst {
  std::uint32_t robot = 0;
  std::uint32_t moves = 0;
};

/// Names a robot and where it would go.
struct Meeting {
  std::uint32_t robot = 0;
  Berth to = kNoBerth;
};

/// Keeps where robots stand and wish to stand in a step of the plan, and finds whom one would come face to face with.
/// Robots in a lane, and ones that go in, keep others from its other end; so do ones that were refused before them.
class Meetings {
 public:
  Meetings(BerthGraph& graph, Lanes& lanes) : graph_(graph), lanes_(lanes) {}

  /// Adds a robot, with the next number.
  void add(Berth at, std::uint32_t methods);
  /// Forgets who was refused in the step before.
  void begin_step() { refused_.clear(); }
  /// Notes that the robot wishes to stand there when the step ends.
  void wishes(std::uint32_t robot, Berth to);
  /// Forgets that wish.
  void takes_back(std::uint32_t robot, Berth to) { erase(robot, to); }
  /// Returns whom the robot would meet if it went there and does not meet anyway, in order of their numbers; it is
  /// refused then.
  std::vector<std::uint32_t> refuse(std::uint32_t robot, Berth to);
  /// Returns whether one that stands there keeps the other one from going to where it would.
  bool would_keep_from(const Lanes::Stand& at, const Meeting& other);
  /// Returns the robots that have to leave a lane before the robot goes there.
  std::vector<MovesFirst> first(std::uint32_t robot, Berth to);
  /// Returns whether the two meet wherever they drive from where they stand.
  bool are_face_to_face(std::uint32_t robot, std::uint32_t other) {
    return lanes_.meet(robots_[robot].at, robots_[other].at);
  }
  /// Returns whether the robot keeps the other one, where they stand, from getting away.
  bool shuts_in(std::uint32_t robot, std::uint32_t other) {
    return lanes_.is_shut_in(robots_[other].at, robots_[robot].at.berth);
  }
  /// Returns whether the other one gets past where the robot stands when that has driven there.
  bool is_aside(std::uint32_t robot, Berth there, std::uint32_t other) {
    const Berth here = robots_[robot].at.berth;
    return !lanes_.is_beside(here, there) && lanes_.gets_past(robots_[other].at, here, there);
  }
  /// Notes that the robot makes its next move: it leaves where it stands.
  void moves(std::uint32_t robot, Berth to);

 private:
  struct Known {
    Lanes::Stand at;
    std::uint32_t moves = 0;
  };
  struct Near {
    std::uint32_t robot = 0;
    Berth berth = kNoBerth;
    std::uint32_t moves = 0;  ///< those that it had made when it left
  };

  template <class Visit>
  void for_each_cut(Berth berth, Visit&& visit);
  void erase(std::uint32_t robot, Berth berth);
  bool meets(std::uint32_t robot, Berth to, std::uint32_t other, Berth at);

  BerthGraph& graph_;
  Lanes& lanes_;
  std::vector<Known> robots_;
  ByBerth<std::vector<Near>> near_;  ///< by cut: robots that stand or wish to stand there, or off the cuts beside it
  ByBerth<std::vector<Near>> left_;  ///< the same of robots that have left, in this plan
  std::vector<Meeting> refused_;
};

}  // namespace weft::server
