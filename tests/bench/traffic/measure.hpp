#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/traffic/fleet.hpp"

namespace weft::bench {

using MakePolicy = std::function<std::unique_ptr<Policy>(Fleet&)>;

/// Holds what a policy did with a fleet, over all seeds.
struct Measured {
  double goals_per_hour = 0.0;   ///< mean of the seeds
  double oldest_goal_min = 0.0;  ///< worst of the seeds, as all that follows
  std::uint64_t overlaps = 0;
  std::vector<double> waits_s;     ///< sorted, of all seeds
  std::uint64_t standstills = 0;   ///< of all seeds
  std::uint64_t lasting = 0;       ///< of these, not resolved at the end
  std::vector<double> resolved_s;  ///< sorted, of the others
  std::vector<double> plan_ms;     ///< sorted, of each step
  std::vector<double> eta_errors;  ///< sorted, of all seeds, as shares of the time left half of the way
  std::uint64_t in_band = 0;       ///< arrivals of these within the band that was foretold
};

/// Measures one seed after the other.
Measured measure(const Network& network, std::uint32_t robots, double hours, std::uint64_t first_seed,
                 std::uint64_t last_seed, const MakePolicy& make);

/// Returns the value that so large a share of the sorted values does not exceed; 0 when there are none.
double quantile(const std::vector<double>& sorted, double share);

}  // namespace weft::bench
