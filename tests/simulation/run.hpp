#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/simulation/fleet.hpp"
#include "tests/simulation/operator.hpp"

namespace weft::simulation {

struct RunConfig {
  FleetConfig fleet;
  People people = People::help;
  Focus focus = Focus::none;  ///< with one, errands come four times as often
  double hours = 1.0;
  double goals_per_robot_hour = 3.0;
};

struct RunResult {
  std::vector<Violation> violations;
  std::vector<Violation> told;  ///< of the invariants that are only to be told
  std::string trace;
  std::uint64_t messages = 0;
  std::uint64_t faults = 0;
  std::uint64_t goals_sent = 0;
  std::uint64_t goals_accepted = 0;
  std::uint64_t acknowledged = 0;
  std::uint64_t refined = 0;    ///< batches that were handed in refined
  std::uint64_t ways_made = 0;  ///< robots that were asked to make way, and standstills that ended
  std::uint64_t stood = 0;      ///< looks at a robot that stood for long with a goal
  std::uint64_t led_back = 0;   ///< robots that a hand led back to where they can set off
  std::uint64_t places = 0;
  double simulated_hours = 0.0;
  std::map<std::string, std::uint64_t> goals;
  std::vector<std::string> diary;  ///< what the server's store holds as events, and how each goal stands
};

/// Runs one whole life of a fleet: taught, sent about under faults, left alone. Pure: the config decides everything.
RunResult run(const RunConfig& config);

}  // namespace weft::simulation
