#include "tests/simulation/run.hpp"

#include <cmath>

#include "tests/simulation/chaos.hpp"

namespace weft::simulation {
namespace {

constexpr Duration kBetweenHelps = std::chrono::seconds(20);
constexpr Duration kUntilAllEnd = std::chrono::minutes(20);
constexpr Duration kUntilAllEndAlone = std::chrono::minutes(60);  // what `progress` allows, and more
constexpr Duration kUntilQuiet = std::chrono::minutes(2);

}  // namespace

RunResult run(const RunConfig& config) {
  Random random(config.fleet.seed * 0x9e3779b97f4a7c15ULL + 1);
  Fleet fleet(config.fleet);
  Chaos chaos(fleet, random.fork(1));
  Operator people(fleet, chaos, random.fork(2), config.people, config.focus);
  const SteadyTime began = fleet.now();
  RunResult result;
  chaos.mild();
  if (!people.begin(config.fleet.map)) result.violations.push_back({"teach", people.trouble()});

  chaos.full();
  const SteadyTime end = fleet.now() + from_seconds(3600.0 * config.hours);
  const double often = config.focus == Focus::none ? 1.0 : 4.0;
  const double robots = static_cast<double>(config.fleet.robots);
  const double mean_s = 3600.0 / (often * config.goals_per_robot_hour / 0.7 * robots);
  SteadyTime next = fleet.now();
  SteadyTime help = fleet.now();
  while (result.violations.empty() && fleet.now() < end && fleet.ledger().violations().empty()) {
    if (fleet.now() >= help) {
      people.help();
      help = fleet.now() + kBetweenHelps;
    }
    if (fleet.now() >= next) {
      people.errand();
      next = fleet.now() + from_seconds(-mean_s * std::log(1.0 - random.uniform()));
    }
    people.pass(std::chrono::seconds(2));
  }
  chaos.over();
  // With nothing broken every goal ends.
  const SteadyTime patience = fleet.now() + (config.people == People::none ? kUntilAllEndAlone : kUntilAllEnd);
  while (fleet.ledger().violations().empty() && people.open_goals() > 0 && fleet.now() < patience) {
    people.help();
    people.pass(kBetweenHelps);
  }
  people.pass(kUntilQuiet);
  if (fleet.ledger().violations().empty()) fleet.look_when_quiet();

  for (const Violation& violation : fleet.ledger().violations()) result.violations.push_back(violation);
  result.told = fleet.ledger().told();
  result.trace = fleet.trace();
  result.messages = fleet.messages();
  result.faults = chaos.played();
  result.goals_sent = people.goals_sent();
  result.goals_accepted = people.goals_accepted();
  result.acknowledged = fleet.ledger().acknowledged();
  result.refined = fleet.ledger().refined();
  result.ways_made = fleet.ways_made();
  result.stood = fleet.ledger().stood();
  result.led_back = people.led_back();
  result.simulated_hours = seconds(fleet.now() - began) / 3600.0 * static_cast<double>(config.fleet.robots);
  result.diary = fleet.diary();
  result.goals = fleet.ledger().goals_by_state();
  return result;
}

}  // namespace weft::simulation
