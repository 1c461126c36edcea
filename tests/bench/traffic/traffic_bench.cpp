#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/traffic/cases.hpp"
#include "tests/bench/traffic/load_table.hpp"
#include "tests/bench/traffic/measure.hpp"

/// Measures fleets of points under several rules, on maps of squares, on a ring with dead ends, and in the cases in
/// which robots come to stand: how many goals are reached, how long robots wait, and who waits for ever.
namespace weft::bench {
namespace {

const std::map<std::string, MakePolicy>& policies() {
  static const std::map<std::string, MakePolicy> all = {{"whole", make_whole},
                                                        {"whole-ask-all", make_whole_asking_all},
                                                        {"ours", make_ours},
                                                        {"prioritised", make_prioritised},
                                                        {"bound", make_bound}};
  return all;
}

struct Options {
  std::string map;
  std::string ring;
  std::string robots = "20";
  double hours = 0.1;
  std::string seeds = "1..1";
  std::string lanes;
  std::string policies = "whole,ours,prioritised,bound";
  std::string load;
  bool cases = false;
  bool json = false;
};

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream list(text);
  for (std::string word; std::getline(list, word, ',');) all.push_back(word);
  return all;
}

std::uint32_t number(const std::string& text, const std::string& what, std::uint32_t most) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value == 0 || value > most) {
    throw CLI::ValidationError(what, "is " + text + "; each of its numbers is from 1 to " + std::to_string(most));
  }
  return value;
}

double memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string per_cent(const nlohmann::json& share) {
  if (share.is_null()) return "-";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f", 100.0 * share.get<double>());
  return text.data();
}

void tell(const Options& options, const std::string& policy, std::uint32_t robots, const std::string& lanes,
          const Measured& measured) {
  double plan_ms = 0.0;
  for (const double step_ms : measured.plan_ms) plan_ms += step_ms / static_cast<double>(measured.plan_ms.size());
  const std::size_t foretold = measured.eta_errors.size();
  const nlohmann::json eta_error =
      foretold > 0 ? nlohmann::json(quantile(measured.eta_errors, 0.5)) : nlohmann::json();
  const nlohmann::json eta_in_band =
      foretold > 0 ? nlohmann::json(static_cast<double>(measured.in_band) / static_cast<double>(foretold))
                   : nlohmann::json();
  if (options.json) {
    const nlohmann::json line = {{"policy", policy},
                                 {"robots", robots},
                                 {"lanes", lanes},
                                 {"goals_per_hour", measured.goals_per_hour},
                                 {"oldest_goal_min", measured.oldest_goal_min},
                                 {"overlaps", measured.overlaps},
                                 {"standstills", measured.standstills},
                                 {"standstills_lasting", measured.lasting},
                                 {"resolved_s", quantile(measured.resolved_s, 0.5)},
                                 {"resolved_longest_s", quantile(measured.resolved_s, 1.0)},
                                 {"wait_s", quantile(measured.waits_s, 0.5)},
                                 {"wait_99_s", quantile(measured.waits_s, 0.99)},
                                 {"wait_longest_s", quantile(measured.waits_s, 1.0)},
                                 {"plan_ms", plan_ms},
                                 {"plan_99_ms", quantile(measured.plan_ms, 0.99)},
                                 {"plan_longest_ms", quantile(measured.plan_ms, 1.0)},
                                 {"eta_error", eta_error},
                                 {"eta_in_band", eta_in_band},
                                 {"memory_mb", memory_mb()}};
    std::cout << line.dump() << std::endl;
    return;
  }
  std::printf(
      "%-13s %6u %-8s %8.0f %7.1f %8.1f %8.1f %8.1f %9llu %6llu %6llu %8.1f %8.3f %8.2f %8.2f %6s %6s %7.0f\n",
      policy.c_str(), robots, lanes.c_str(), measured.goals_per_hour, measured.oldest_goal_min,
      quantile(measured.waits_s, 0.5), quantile(measured.waits_s, 0.99), quantile(measured.waits_s, 1.0),
      static_cast<unsigned long long>(measured.overlaps), static_cast<unsigned long long>(measured.standstills),
      static_cast<unsigned long long>(measured.lasting), quantile(measured.resolved_s, 0.5), plan_ms,
      quantile(measured.plan_ms, 0.99), quantile(measured.plan_ms, 1.0), per_cent(eta_error).c_str(),
      per_cent(eta_in_band).c_str(), memory_mb());
  std::fflush(stdout);
}

Network network_of(const Options& options, const std::string& lanes) {
  if (!options.ring.empty()) {
    const std::vector<std::string> sizes = words(options.ring);
    if (sizes.size() != 2) throw CLI::ValidationError("--ring", "is " + options.ring + "; it is CELLS,DEAD_ENDS");
    const std::uint32_t cells = number(sizes[0], "--ring", 10'000);
    return bench::ring(cells, number(sizes[1], "--ring", cells / 2));
  }
  const Lanes how = lanes == "one-way" ? Lanes::one_way : Lanes::two_way;
  if (options.map.empty()) return bench::network_of(options.load.empty() ? warehouse(5, 8) : warehouse(14, 20), how);
  std::ifstream file(options.map);
  if (!file) throw CLI::ValidationError("MAP", options.map + " cannot be read");
  const Result<Grid> grid = read_grid(file);
  if (!grid) throw CLI::ValidationError("MAP", options.map + ": " + grid.error().message);
  return bench::network_of(*grid, how);
}

std::pair<std::uint32_t, std::uint32_t> seeds_of(const Options& options) {
  const auto dots = options.seeds.find("..");
  const std::uint32_t first = number(options.seeds.substr(0, dots), "--seeds", 1'000'000);
  const std::uint32_t last =
      dots == std::string::npos ? first : number(options.seeds.substr(dots + 2), "--seeds", 1'000'000);
  if (last < first) throw CLI::ValidationError("--seeds", "is " + options.seeds + "; it is A..B with A <= B");
  return {first, last};
}

std::vector<std::string> lanes_of(const Options& options) {
  if (!options.ring.empty()) return {"ring"};
  if (options.lanes.empty()) return {"one-way", "two-way"};
  return {options.lanes};
}

/// Loads a server with each number of robots, twice: with goals, and beside it with nothing but their reports.
void run_loads(const Options& options) {
  const auto [first, last] = seeds_of(options);
  if (!options.json) tell_load_head();
  for (const std::string& lanes : lanes_of(options)) {
    const Network network = network_of(options, lanes);
    const TaughtLanes taught(network);
    for (const std::string& count : words(options.load)) {
      const std::uint32_t robots = number(count, "--load", static_cast<std::uint32_t>(network.size() / 2));
      for (std::uint32_t seed = first; seed <= last; ++seed) {
        for (const bool has_goals : {false, true}) {
          const LoadPlan plan{
              .robots = robots, .has_goals = has_goals, .seconds = 3600.0 * options.hours, .seed = seed};
          tell_load(plan, lanes, load_server(taught, plan), options.json);
        }
      }
    }
  }
}

void run(const Options& options) {
  const auto [first, last] = seeds_of(options);
  for (const std::string& policy : words(options.policies)) {
    if (!policies().contains(policy)) {
      throw CLI::ValidationError("--policies",
                                 "has " + policy + "; there are whole, whole-ask-all, ours, prioritised and bound");
    }
  }
  if (!options.json) {
    std::printf("%-13s %6s %-8s %8s %7s %8s %8s %8s %9s %6s %6s %8s %8s %8s %8s %6s %6s %7s\n", "POLICY", "ROBOTS",
                "LANES", "GOALS/H", "OLD min", "WAIT s", "99 %", "longest", "OVERLAPS", "STANDS", "last", "solved s",
                "PLAN ms", "99 %", "longest", "ETA %", "band %", "MB");
  }
  for (const std::string& lanes : lanes_of(options)) {
    const Network network = network_of(options, lanes);
    for (const std::string& count : words(options.robots)) {
      const std::uint32_t robots = number(count, "--robots", static_cast<std::uint32_t>(network.size() / 2));
      for (const std::string& policy : words(options.policies)) {
        tell(options, policy, robots, lanes,
             measure(network, robots, options.hours, first, last, policies().at(policy)));
      }
    }
  }
}

int measure_fleets(int argc, char** argv) {
  CLI::App app("Measures how well a fleet keeps moving; without MAP on a small warehouse of its own");
  Options options;
  app.add_option("MAP", options.map, "A floor as movingai writes it: type octile, height, width, map");
  app.add_option("--ring", options.ring, "CELLS,DEAD_ENDS instead of a map: a ring driven one way");
  app.add_option("--robots", options.robots, "How many; several numbers with commas between")->capture_default_str();
  app.add_option("--hours", options.hours, "Simulated")->check(CLI::Range(0.01, 24.0))->capture_default_str();
  app.add_option("--seeds", options.seeds, "A..B")->capture_default_str();
  app.add_option("--lanes", options.lanes, "Only these")->check(CLI::IsMember({"one-way", "two-way"}));
  app.add_option("--policies", options.policies, "Only these, with commas between")->capture_default_str();
  app.add_flag("--cases", options.cases, "The cases in which robots come to stand, by the whole server");
  app.add_option(
      "--load", options.load,
      "The whole server's share of a core with so many robots, and how long each thing that it does takes");
  app.add_flag("--json", options.json, "A document a line");
  try {
    app.parse(argc, argv);
    if (options.cases) return tell_cases(std::cout, options.json);
    if (!options.load.empty()) {
      run_loads(options);
    } else {
      run(options);
    }
  } catch (const CLI::ParseError& wrong) {
    return app.exit(wrong) == 0 ? 0 : 2;
  }
  return 0;
}

}  // namespace
}  // namespace weft::bench

int main(int argc, char** argv) {
  try {
    return weft::bench::measure_fleets(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "traffic_bench: %s\n", error.what());
    return 1;
  }
}
