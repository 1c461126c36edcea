#pragma once
#include <string>
#include <vector>

#include "clients/cli/json.hpp"

namespace weft::cli {

/// Returns the robot that was asked about, if it waits, then all for whom it waits, and for whom these do, each once,
/// nearest first. The last ones do not wait, unless they wait in a circle.
std::vector<const msg::RobotRow*> wait_chain(const std::vector<msg::RobotRow>& robots, const RobotId& robot);

/// Returns the chain as a sentence: "r7 waits 41 s at 10:88 for r3, which waits for r9, which is idle".
std::string chain_text(const std::vector<msg::RobotRow>& robots, const RobotId& robot, WallTime now);

/// Returns a document of each robot of the chain that waits.
nlohmann::json chain_json(const std::vector<msg::RobotRow>& robots, const RobotId& robot);

/// Returns the standstills that robots are in, each once.
std::vector<std::string> standstills(const std::vector<msg::RobotRow>& robots);

}  // namespace weft::cli
