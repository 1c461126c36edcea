#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "agents/agent/blocked_watch.hpp"
#include "agents/agent/safety_stop.hpp"
#include "agents/perception/motion.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

/// Is what a navigator stands for whose method sees something in its way, and what is told of a route that is given
/// up for it.
inline constexpr std::string_view kSomethingAhead = "blocked";

/// Describes the condition of the robot: what the last sample showed of it, and what keeps it from driving.
struct Condition {
  std::uint64_t frame = 0;
  double speed_m_s = 0.0;
  Twist command;           ///< of the navigator
  std::string stands_for;  ///< the navigator's reason
  bool lost = false;
  bool may_look_around = false;  ///< by turning on the spot, as somebody waits for it
  bool stopped = false;          ///< by an operator
  std::string fault;             ///< of the body; empty: none
  SafetyStop safety;             ///< of the base
  BlockedWatch blocked;          ///< by what is seen

  /// Returns what a person has to end.
  storage::Stops stops() const { return {.by_operator = stopped, .by_emergency_stop = safety.is_latched()}; }
  bool is_faulted() const { return !fault.empty(); }
  /// Returns the navigator's command, or none for a robot that has to stand. A lost one turns at most.
  Twist allowed_command() const {
    if (is_kept_standing() || is_faulted()) return Twist{};
    return lost ? Twist{0.0, may_look_around ? command.angular_rad_s : 0.0} : command;
  }
  /// Returns what others are told of the base, and of what holds the robot.
  Safety shown() const { return blocked.is_blocked() && !is_stop(safety.shown()) ? Safety::blocked : safety.shown(); }
  /// Returns whether an operator or the base's safety keeps the robot from driving.
  bool is_kept_standing() const { return stopped || safety.keeps_from_driving(); }
  /// Returns whether its method has it stand before something that it sees.
  bool sees_something() const { return stands_for == kSomethingAhead && !is_kept_standing() && !is_faulted(); }
};

}  // namespace weft::agents
