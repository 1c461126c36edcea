#pragma once
#include <optional>
#include <string>

#include "agents/agent/condition.hpp"
#include "agents/agent/route_task.hpp"
#include "core/protocol/messages.hpp"

namespace weft::agents {

/// Decides the robot's mode and the reason that it gives for it.
struct Standing {
  const Condition& condition;
  const RouteTask& task;
  const std::string& incompatible;      ///< why it cannot work with its server; empty: it can
  std::optional<std::string> taught;    ///< being taught: what teaching waits for
  const std::string& teaching_failure;  ///< why teaching ended by itself
  std::string searches;                 ///< how it looks for itself; empty: it does not
  const std::string& route_waits_for;   ///< why its route is not followed yet
  std::string notice;                   ///< of what people should look at
  std::string safety{};                 ///< how its base's safety keeps it from driving; empty: it does not
  std::string refines{};                ///< how far it is with what it was taught; empty: it refines nothing
};

msg::RobotMode mode_of(const Standing& standing);
/// Says, for people and for scripts, why the robot is in its mode; empty: nothing is to be said.
std::string reason_of(const Standing& standing);

}  // namespace weft::agents
