#pragma once
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/condition.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Returns the line that the hand is asked to drive.
std::vector<SitePoint> line_of(const msg::AgentCommand& command);

/// Checks whether a robot that is not being taught can be taught as the command says. refused: why not.
Result<void> check_teach_start(const msg::AgentCommand& command, const AgentConfig& config,
                               const Condition& condition, bool has_route);

/// Checks the same for a robot that is being taught this run, and whose hand is to drive another line of it.
Result<void> check_next_part(const AgentConfig& config, const Condition& condition);

}  // namespace weft::agents
