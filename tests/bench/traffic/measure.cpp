#include "tests/bench/traffic/measure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/bench/times.hpp"

namespace weft::bench {
namespace {

constexpr int kBetweenGraphs = 5;     // steps from one look at who waits for whom to the next
constexpr int kBetweenOverlaps = 26;  // steps, about a minute

/// Follows standstills from when they are seen to when they are not any more.
class Standing {
 public:
  void look(Policy& policy, int now) {
    std::map<std::vector<RobotId>, int> before = std::exchange(since_, {});
    for (const server::Standstill& standstill : server::standstills(policy.waits(), {})) {
      const auto was = before.find(standstill.core);
      if (was == before.end()) ++seen;
      since_[standstill.core] = was == before.end() ? now : was->second;
      if (was != before.end()) before.erase(was);
    }
    for (const auto& [core, since] : before) resolved_s.push_back(kStep_s * (now - since));
  }
  std::uint64_t seen = 0;
  std::vector<double> resolved_s;
  std::uint64_t lasting() const { return since_.size(); }

 private:
  std::map<std::vector<RobotId>, int> since_;
};

void add(std::vector<double>& to, const std::vector<double>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

void run(const Network& network, std::uint32_t robots, double hours, std::uint64_t seed, const MakePolicy& make,
         Measured& all) {
  Fleet fleet(network, robots, seed);
  const std::unique_ptr<Policy> policy = make(fleet);
  const int steps = static_cast<int>(std::lround(3600.0 * hours / kStep_s));
  Standing standing;
  for (int step = 0; step < steps; ++step) {
    all.plan_ms.push_back(timed([&] { policy->step(); }).processor_ms);
    fleet.end_step();
    if (step % kBetweenGraphs == 0) standing.look(*policy, step);
    if (step % kBetweenOverlaps == 0) all.overlaps = std::max(all.overlaps, policy->overlaps());
  }
  all.goals_per_hour += static_cast<double>(fleet.goals_done) / hours;
  all.oldest_goal_min = std::max(all.oldest_goal_min, kStep_s * fleet.oldest / 60.0);
  for (const int wait : fleet.waits) all.waits_s.push_back(kStep_s * wait);
  for (const Robot& robot : fleet.robots()) {
    const bool stands = robot.handles == 0 && fleet.now() > robot.stands_since;
    if (stands) all.waits_s.push_back(kStep_s * (fleet.now() - robot.stands_since));
  }
  all.standstills += standing.seen;
  all.lasting += standing.lasting();
  add(all.resolved_s, standing.resolved_s);
  for (const Foreseen& arrival : policy->foreseen()) {
    all.eta_errors.push_back(arrival.error);
    if (arrival.is_in_band) ++all.in_band;
  }
}

}  // namespace

Measured measure(const Network& network, std::uint32_t robots, double hours, std::uint64_t first_seed,
                 std::uint64_t last_seed, const MakePolicy& make) {
  Measured all;
  for (std::uint64_t seed = first_seed; seed <= last_seed; ++seed) run(network, robots, hours, seed, make, all);
  all.goals_per_hour /= static_cast<double>(last_seed - first_seed + 1);
  for (std::vector<double>* const values : {&all.waits_s, &all.resolved_s, &all.plan_ms, &all.eta_errors}) {
    std::sort(values->begin(), values->end());
  }
  return all;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::ceil(share * last))];
}

}  // namespace weft::bench
