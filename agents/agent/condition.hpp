#pragma once
#include <cstdint>
#include <string>

#include "agents/agent/blocked_watch.hpp"
#include "agents/agent/safety_stop.hpp"
#include "agents/perception/motion.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

/// Describes the condition of the robot: what the last sample showed of it, and what keeps it from driving.
struct Condition {
  std::uint64_t frame = 0;
  double speed_m_s = 0.0;
  Twist command;           ///< of the navigator
  std::string stands_for;  ///< the navigator's reason
  bool lost = false;
  bool stopped = false;  ///< by an operator
  std::string fault;     ///< of the body; empty: none
  SafetyStop safety;     ///< of the base
  BlockedWatch blocked;  ///< by what is seen

  /// Returns what a person has to end.
  storage::Stops stops() const { return {.by_operator = stopped, .by_emergency_stop = safety.is_latched()}; }
  bool is_faulted() const { return !fault.empty(); }
  /// Returns the navigator's command, or none for a robot that has to stand.
  Twist allowed_command() const { return is_kept_standing() || lost || is_faulted() ? Twist{} : command; }
  /// Returns what others are told of the base, and of what holds the robot.
  Safety shown() const { return blocked.is_blocked() && !is_stop(safety.shown()) ? Safety::blocked : safety.shown(); }
  /// Returns whether an operator or the base's safety keeps the robot from driving.
  bool is_kept_standing() const { return stopped || safety.keeps_from_driving(); }
};

}  // namespace weft::agents
