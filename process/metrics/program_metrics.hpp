#pragma once
#include <string>

#include "process/metrics/durations.hpp"
#include "process/metrics/metric.hpp"

namespace weft::process {

/// Holds what a program of Weft says of itself in its metrics, whichever it is.
struct ProgramFigures {
  std::string program;
  std::string version;
  std::string vendor;   ///< of its bus
  double away_s = 0.0;  ///< in which it was away from its inbox, each time for more than a second
  bool is_well = true;  ///< it does its work, as its health says
  Durations handled{};  ///< each message
  Durations ticked{};   ///< each turn of what is due by the clock
};

Metrics program_metrics(const ProgramFigures& figures);

}  // namespace weft::process
