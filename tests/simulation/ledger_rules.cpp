#include <algorithm>

#include "tests/simulation/ledger.hpp"

/// Checks by the truth that nobody is released into what rules have closed.
namespace weft::simulation {

/// Returns the least distance to where the rule closes the floor.
double Ledger::away_from_closed_m(const Rule& rule, const Pose2& at) const {
  double least_m = 1e9;
  for (const Span& span : rule.spans) {
    const auto [first, last] = std::minmax(span.from.index, span.to.index);
    for (std::uint32_t index = first; index <= last; ++index) {
      if (const auto closed = truth_of({span.from.experience, index}))
        least_m = std::min(least_m, (closed->translation() - at.translation()).norm());
    }
  }
  return least_m;
}

/// The way from what was released before to what is released now does not lead in from outside. What lies between the
/// two distances may count as either.
void Ledger::check_rules(const Route& route, std::uint32_t first, const Snapshot& snapshot) {
  constexpr double inside_m = 0.15;
  constexpr double outside_m = 0.8;
  for (const auto& [name, rule] : snapshot.rules()) {
    if (rule.kind != RuleKind::closed || rule.one_direction) continue;
    bool was_outside = false;
    for (std::uint32_t i = first > 0 ? first - 1 : 0; i <= route.released && i < route.places.size(); ++i) {
      const auto place = truth_of(route.places[i]);
      if (!place) continue;
      const double away_m = away_from_closed_m(rule, *place);
      was_outside = was_outside || away_m > outside_m;
      if (!was_outside || away_m > inside_m) continue;
      broken("rules", robots.at(route.robot).name + " was released to " + to_string(route.places[i]) +
                          " which rule " + name + " closes");
      break;
    }
  }
}

}  // namespace weft::simulation
