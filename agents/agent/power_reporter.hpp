#pragma once
#include <optional>

#include "agents/perception/sample.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Decides when the robot tells what its battery holds: each five seconds, and at once when it begins or ends to
/// charge. A body that does not know its charge says nothing.
class PowerReporter {
 public:
  /// Takes what a sample says.
  void take(const std::optional<Charge>& charge, SteadyTime now);
  /// Returns what to send now; none: nothing.
  std::optional<msg::RobotPower> due(SteadyTime now);
  /// Has the charge told at once: another server knows nothing of this robot.
  void server_restarted(SteadyTime now) { next_ = now; }
  std::optional<SteadyTime> next() const;

 private:
  std::optional<Charge> charge_;
  SteadyTime next_;
};

}  // namespace weft::agents
