#pragma once
#include <cstdint>

#include "agents/agent/agent.hpp"
#include "process/metrics/durations.hpp"
#include "process/metrics/metric.hpp"

namespace weft::agents {

/// Holds what the loop around an agent counts of it.
struct DriveFigures {
  std::uint64_t frames = 0;
  double lost_s = 0.0;           ///< in which the robot was lost
  double silent_server_s = 0.0;  ///< since the server was heard last, or since the start
  bool has_body_failed = false;
  process::Durations stepped{};  ///< each sample: seeing, deciding, sending
};

/// Returns the metrics of one robot's agent.
process::Metrics agent_metrics(const AgentFigures& figures, const DriveFigures& drive);

}  // namespace weft::agents
