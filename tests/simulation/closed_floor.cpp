#include "tests/simulation/closed_floor.hpp"

#include <algorithm>

namespace weft::simulation {
namespace {

/// Returns the least distance from the floor that the rule's spans lead over; they lie along runs.
double away_m(const Rule& rule, const Pose2& at, const Truth& truth) {
  double least_m = 1e9;
  for (const Span& span : rule.spans) {
    const auto [first, last] = std::minmax(span.from.index, span.to.index);
    for (std::uint32_t index = first; index <= last; ++index) {
      if (const auto closed = truth({span.from.experience, index}))
        least_m = std::min(least_m, (closed->translation() - at.translation()).norm());
    }
  }
  return least_m;
}

}  // namespace

std::optional<PlaceId> enters_closed(const Rule& rule, const Route& route, std::uint32_t first, const Truth& truth) {
  constexpr double inside_m = 0.15;
  constexpr double outside_m = 0.8;
  bool was_outside = false;
  for (std::uint32_t i = first > 0 ? first - 1 : 0; i <= route.released && i < route.places.size(); ++i) {
    const auto place = truth(route.places[i]);
    if (!place) continue;
    const double away = away_m(rule, *place, truth);
    was_outside = was_outside || away > outside_m;
    if (was_outside && away < inside_m) return route.places[i];
  }
  return std::nullopt;
}

}  // namespace weft::simulation
