#include "server/dispatcher/capacity.hpp"

#include <algorithm>

namespace weft::server {
namespace {

/// Returns how many robots hold a place where the rule holds.
std::size_t robots_inside(const RuleMap& rules, const std::string& rule, const HeldPlaces& others) {
  const auto is_inside = [&](const auto& held) {
    return std::ranges::any_of(held.second,
                               [&](const PlaceId& place) { return rules.capacities(place).contains(rule); });
  };
  return static_cast<std::size_t>(std::ranges::count_if(others, is_inside));
}

}  // namespace

ReleasedByRules released_by_capacity(const RuleMap& rules, const Route& route, std::uint32_t from,
                                     std::optional<std::uint32_t> through, const HeldPlaces& others) {
  if (!rules.counts_robots() || from >= route.places.size()) return {through, {}};
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  // Names the rule also for a robot that others let no farther, if the rule is the next thing.
  const std::uint32_t farthest = through ? *through : std::min(from + 1, last);
  for (std::uint32_t at = from + 1; at <= farthest; ++at) {
    const std::map<std::string, std::size_t> before = rules.capacities(route.places[at - 1]);
    for (const auto& [name, most] : rules.capacities(route.places[at])) {
      if (before.contains(name) || robots_inside(rules, name, others) < most) continue;
      // The first place of a route is where the robot stands: that it may have.
      const bool is_more = through && (at - 1 > from || at == 1);
      return {is_more ? std::optional(at - 1) : std::nullopt, name};
    }
  }
  return {through, {}};
}

}  // namespace weft::server
