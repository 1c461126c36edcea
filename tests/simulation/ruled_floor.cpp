#include "tests/simulation/ruled_floor.hpp"

#include <algorithm>

namespace weft::simulation {
namespace {

/// Returns the least distance from the floor that the rule's spans lead over; they lie along runs.
double away_m(const Rule& rule, const Pose2& at, const Truth& truth) {
  double least_m = 1e9;
  for (const Span& span : rule.spans) {
    const auto [first, last] = std::minmax(span.from.index, span.to.index);
    for (std::uint32_t index = first; index <= last; ++index) {
      if (const auto ruled = truth({span.from.experience, index}))
        least_m = std::min(least_m, (ruled->translation() - at.translation()).norm());
    }
  }
  return least_m;
}

constexpr double kInside_m = 0.15;

/// Returns the lowest limit that the route states for its place of that index; none: it states none.
std::optional<double> stated_limit_m_s(const Route& route, std::uint32_t index) {
  std::optional<double> lowest_m_s;
  for (const SpeedLimit& limit : route.limits) {
    if (index < limit.from || index > limit.to) continue;
    lowest_m_s = std::min(lowest_m_s.value_or(limit.limit_m_s), limit.limit_m_s);
  }
  return lowest_m_s;
}

}  // namespace

std::optional<PlaceId> enters_closed(const Rule& rule, const Route& route, std::uint32_t first, const Truth& truth) {
  constexpr double outside_m = 0.8;
  bool was_outside = false;
  for (std::uint32_t i = first > 0 ? first - 1 : 0; i <= route.released && i < route.places.size(); ++i) {
    const auto place = truth(route.places[i]);
    if (!place) continue;
    const double away = away_m(rule, *place, truth);
    was_outside = was_outside || away > outside_m;
    if (was_outside && away < kInside_m) return route.places[i];
  }
  return std::nullopt;
}

std::optional<PlaceId> lacks_limit(const Rule& rule, const Route& route, std::uint32_t first, const Truth& truth) {
  for (std::uint32_t i = first; i <= route.released && i < route.places.size(); ++i) {
    const auto place = truth(route.places[i]);
    if (!place || away_m(rule, *place, truth) > kInside_m) continue;
    const std::optional<double> stated_m_s = stated_limit_m_s(route, i);
    if (!stated_m_s || *stated_m_s > rule.value) return route.places[i];
  }
  return std::nullopt;
}

}  // namespace weft::simulation
