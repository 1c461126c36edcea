#include "agents/agent/safety_stop.hpp"

namespace weft::agents {

bool SafetyStop::take(Safety safety) {
  const bool held = holds();
  safety_ = safety;
  if (safety == Safety::emergency_stop) is_latched_ = true;
  if (holds()) awaits_fix_ = true;
  return holds() && !held;
}

bool SafetyStop::resume() {
  if (safety_ == Safety::emergency_stop) return false;
  is_latched_ = false;
  return true;
}

std::string SafetyStop::reason(const std::string& name) const {
  if (safety_ == Safety::emergency_stop) {
    return "emergency stop: see what is wrong, release it at the robot, then weft resume " + name;
  }
  if (is_latched_) return "its emergency stop was released: weft resume " + name + " lets it go on";
  if (safety_ == Safety::protective_stop) return "protective stop: it goes on when its base allows";
  return awaits_fix_ ? "waits until it has seen where it is, after a stop of its base" : "";
}

}  // namespace weft::agents
