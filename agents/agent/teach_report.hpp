#pragma once
#include <string>

#include "agents/navigation/navigator.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Reports how what the robot was taught will be found again: of the run that goes on, or of the last one. `name`:
/// the run that was asked for; empty: any. refused: there is nothing to report on, or it is of another run.
Result<msg::AgentReply> teach_report(const Navigator& navigator, const std::string& robot, const std::string& name);

}  // namespace weft::agents
