#pragma once
#include <string>

#include "core/safety.hpp"

namespace weft::agents {

/// Follows what the base's own safety does with the robot. The base stops by itself, without Weft; this decides when
/// the robot may be driven again: after a protective stop when the base allows, after an emergency stop when a person
/// resumes it, and after both once it has seen where it is.
class SafetyStop {
 public:
  /// Takes what a sample says. Returns whether a stop begins with it.
  bool take(Safety safety);
  /// Takes a fix.
  void fixed() { awaits_fix_ = awaits_fix_ && holds(); }
  /// Takes a person's word that it may go on. False: the emergency stop is still pressed.
  bool resume();
  /// Takes up an emergency stop of before the agent was started.
  void restore() { is_latched_ = awaits_fix_ = true; }

  /// Returns whether the robot has to stand, whatever anybody asks for.
  bool holds() const { return is_stop(safety_) || is_latched_; }
  /// Returns whether it may not be driven yet: it stands, or has not seen since where it is.
  bool keeps_from_driving() const { return holds() || awaits_fix_; }
  /// Returns whether it stands until a person resumes it.
  bool is_latched() const { return is_latched_; }
  /// Returns what others are told: an emergency stop lasts until a person ends it.
  Safety shown() const { return is_latched_ ? Safety::emergency_stop : safety_; }
  /// Says why it does not drive, for people; empty: nothing here keeps it.
  std::string reason(const std::string& name) const;

 private:
  Safety safety_ = Safety::ok;
  bool is_latched_ = false;  ///< there was an emergency stop, and nobody has resumed the robot
  bool awaits_fix_ = false;
};

}  // namespace weft::agents
