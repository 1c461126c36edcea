#pragma once
#include <array>

#include "agents/agent/process/recorded_body.hpp"
#include "agents/agent/process/simulated/simulated_body.hpp"

namespace weft::agents::test {

inline constexpr std::array kAllBodies = {kSimulatedBody, kRecordedBody};
inline constexpr std::array kBodiesOfRobots = {kRecordedBody};
/// Is weft-agent-sim.
inline constexpr Program kSimulator = {"weft-agent-sim", kAllBodies};
/// Is weft-agent.
inline constexpr Program kRobotsAgent = {"weft-agent", kBodiesOfRobots};

}  // namespace weft::agents::test
