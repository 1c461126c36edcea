#pragma once
#include <cmath>

#include "agents/control/tracker.hpp"
#include "agents/navigation/config.hpp"

namespace weft::agents {

/// Drives the last centimetres: stands until the goal is seen, then creeps, steps aside or turns until position and
/// heading are good enough. A value: the state between samples. Each move ends at its aim or when that is passed, and
/// there are few: where estimates of the goal jump by more than the aim is wide, it comes to an end as well.
class Arrival {
 public:
  struct Out {
    Twist command;
    bool arrived = false;
    std::string_view reason;  ///< set when it gives up: "goal_not_reached"
  };

  /// Returns whether the last centimetres have begun; from then on the path is not followed any more.
  bool begun() const { return phase_ != Phase::path; }
  void begin();
  void reset() { *this = Arrival{}; }
  /// Returns whether the robot stands and waits for a fix.
  bool waits_for_fix() const { return phase_ == Phase::settle; }

  /// Decides on one sample. `fresh`: there was a fix since the robot has stood still.
  Out step(const FollowConfig& config, const TrackerConfig& tracker, const Pose2& robot_from_goal, bool fresh);

 private:
  enum class Phase : std::uint8_t { path, settle, creep, face, approach, turn };
  Out settled(const FollowConfig& config, const Pose2& robot_from_goal);
  Out act(const FollowConfig& config, const TrackerConfig& tracker, const Pose2& robot_from_goal);
  Out settle();
  void turn_to(const Pose2& robot_from_goal);
  /// Returns whether what is left of the phase, metres or radians, has changed its sign: the robot has passed it.
  bool has_passed(double left) const { return std::signbit(left) != std::signbit(left_at_begin_); }

  Phase phase_ = Phase::path;
  Tracker tracker_;
  double left_at_begin_ = 0.0;  ///< of a creep or a turn
  std::uint32_t standing_ = 0;
  std::uint32_t moving_ = 0;  ///< samples of the move under way
  std::uint32_t moves_ = 0;
};

}  // namespace weft::agents
