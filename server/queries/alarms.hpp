#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/query_messages.hpp"
#include "server/base/now.hpp"

namespace weft::server {

/// Returns what is wrong now, server first, robots in their order. `since` is 1970 where what is known does not say.
/// The last state of a robot that is not heard does not count; a robot whose agent was ended is not missed.
std::vector<msg::Alarm> alarms_of(const msg::MapInfo& info, const std::vector<msg::RobotRow>& robots, WallTime now);

/// Returns whether a counter of that name counts messages that were refused.
bool counts_refused(const std::string& counter);

}  // namespace weft::server
