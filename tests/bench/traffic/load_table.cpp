#include "tests/bench/traffic/load_table.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "tests/bench/traffic/measure.hpp"

namespace weft::bench {
namespace {

/// Sums up what acts of one kind took.
struct Summary {
  double per_s = 0.0;
  double share = 0.0;  ///< of a core
  std::vector<double> processor_ms;
  std::vector<double> wall_ms;
};

Summary summary_of(const std::vector<Took>& times, double lasting_s) {
  Summary sum;
  for (const Took& took : times) {
    sum.share += took.processor_ms / 1e3 / lasting_s;
    sum.processor_ms.push_back(took.processor_ms);
    sum.wall_ms.push_back(took.wall_ms);
  }
  sum.per_s = static_cast<double>(times.size()) / lasting_s;
  std::sort(sum.processor_ms.begin(), sum.processor_ms.end());
  std::sort(sum.wall_ms.begin(), sum.wall_ms.end());
  return sum;
}

/// Sums up each kind of act, all messages together (`handle`), and everything (`all`).
std::vector<std::pair<std::string, Summary>> summaries_of(const Loaded& loaded, double lasting_s) {
  std::vector<std::pair<std::string, Summary>> rows;
  std::vector<Took> handled;
  for (std::size_t i = 0; i < kWorks; ++i) {
    const auto work = static_cast<Work>(i);
    if (work != Work::tick) handled.insert(handled.end(), loaded.times[i].begin(), loaded.times[i].end());
    rows.emplace_back(to_string(work), summary_of(loaded.times[i], lasting_s));
  }
  rows.emplace_back("handle", summary_of(handled, lasting_s));
  const std::vector<Took>& ticks = loaded.times[static_cast<std::size_t>(Work::tick)];
  handled.insert(handled.end(), ticks.begin(), ticks.end());
  rows.emplace_back("all", summary_of(handled, lasting_s));
  return rows;
}

nlohmann::json to_json(const Summary& sum) {
  return {{"per_s", sum.per_s},
          {"share", sum.share},
          {"median_ms", quantile(sum.processor_ms, 0.5)},
          {"p99_ms", quantile(sum.processor_ms, 0.99)},
          {"longest_ms", quantile(sum.processor_ms, 1.0)},
          {"wall_p99_ms", quantile(sum.wall_ms, 0.99)},
          {"wall_longest_ms", quantile(sum.wall_ms, 1.0)}};
}

}  // namespace

void tell_load_head() {
  std::printf("%6s %-8s %-6s %-9s %9s %8s %9s %9s %10s %9s %10s\n", "ROBOTS", "LANES", "GOALS", "WHAT", "A SECOND",
              "CORE %", "MEDIAN ms", "99 %", "longest", "wall 99 %", "longest");
}

void tell_load(const LoadPlan& plan, const std::string& lanes, const Loaded& loaded, bool json) {
  const auto rows = summaries_of(loaded, plan.seconds);
  if (json) {
    nlohmann::json line = {{"robots", plan.robots},
                           {"lanes", lanes},
                           {"has_goals", plan.has_goals},
                           {"seed", plan.seed},
                           {"seconds", plan.seconds},
                           {"driving", loaded.driving},
                           {"goals_per_hour", loaded.goals_per_hour},
                           {"commits_per_s", loaded.commits_per_s},
                           {"orders_per_s", loaded.orders_per_s},
                           {"refused", loaded.refused},
                           {"warm_up_longest_ms", loaded.warm_up_longest_ms}};
    for (const auto& [name, sum] : rows) line[name] = to_json(sum);
    std::cout << line.dump() << std::endl;
    return;
  }
  for (const auto& [name, sum] : rows) {
    if (sum.processor_ms.empty()) continue;
    std::printf("%6u %-8s %-6s %-9s %9.1f %8.2f %9.3f %9.3f %10.2f %9.3f %10.2f\n", plan.robots, lanes.c_str(),
                plan.has_goals ? "yes" : "none", name.c_str(), sum.per_s, 1e2 * sum.share,
                quantile(sum.processor_ms, 0.5), quantile(sum.processor_ms, 0.99), quantile(sum.processor_ms, 1.0),
                quantile(sum.wall_ms, 0.99), quantile(sum.wall_ms, 1.0));
  }
  std::printf(
      "       %.0f %% drive, %.0f goals/h, %.1f commits/s, %.1f orders/s, %llu refused; longest of the warm-up %.1f "
      "ms\n",
      1e2 * loaded.driving, loaded.goals_per_hour, loaded.commits_per_s, loaded.orders_per_s,
      static_cast<unsigned long long>(loaded.refused), loaded.warm_up_longest_ms);
  std::fflush(stdout);
}

}  // namespace weft::bench
