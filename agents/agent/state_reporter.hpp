#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Decides when the robot describes itself and when it reports its state: at once on a change that matters, at most
/// ten times a second, and now and then without one.
class StateReporter {
 public:
  explicit StateReporter(SteadyTime now) : describe_at_(now), state_at_(now), sent_at_(now) {}

  /// Returns whether to send a description now.
  bool description_due(SteadyTime now);
  /// Returns whether to send this state now.
  bool state_due(const msg::RobotState& state, SteadyTime now);
  /// Makes a state due, changed or not.
  void hurry(SteadyTime now) { state_at_ = now; }
  /// Makes a description and a state due, as another server knows nothing of this robot.
  void server_restarted(SteadyTime now);
  SteadyTime next() const;

 private:
  /// Holds the fields of which a change matters.
  struct Shown {
    msg::RobotMode mode{};
    bool localised = false;
    RouteId route;
    std::uint32_t version = 0;
    ExperienceId experience;
    Digest window;
    bool complete = false;
    std::string reason;
    bool spool_refuses = false;
    bool is_deaf = false;
    bool operator==(const Shown&) const = default;
  };
  static Shown shown(const msg::RobotState& state);

  SteadyTime describe_at_;
  SteadyTime state_at_;  ///< next state without a change
  SteadyTime sent_at_;   ///< last state
  Shown said_;
};

/// Returns what does not change while the agent runs.
msg::RobotDescription description_of(const AgentConfig& config, const std::vector<std::string>& drives);

}  // namespace weft::agents
