#pragma once
#include <cstdint>

#include "tests/bench/traffic/served.hpp"

namespace weft::bench {

/// Says how a server is loaded: with so many robots, which all have goals, or all stand and only report.
struct LoadPlan {
  std::uint32_t robots = 200;
  bool has_goals = true;
  double seconds = 60.0;  ///< simulated, that are measured
  std::uint64_t seed = 1;
};

/// Holds what a loaded server did.
struct Loaded {
  Timed times;
  double warm_up_longest_ms = 0.0;  ///< the processor's time of the longest act before
  double driving = 0.0;             ///< share of the robots
  double goals_per_hour = 0.0;      ///< sent, as many as end
  double commits_per_s = 0.0;       ///< each a synchronised write of a store on disk
  double orders_per_s = 0.0;        ///< said by the server
  std::uint64_t refused = 0;        ///< goals
};

/// Runs a server for a simulated minute with the robots, and then measures.
Loaded load_server(const TaughtLanes& lanes, const LoadPlan& plan);

}  // namespace weft::bench
