#include "server/traffic/stretch.hpp"

#include <algorithm>

#include "core/network/relation.hpp"

namespace weft::server {
namespace {

constexpr double kHop_m = 0.5;  ///< between two places of a run of which nothing is known
constexpr std::uint32_t kLastHops = 10;

/// Returns the longest of the last hops before the run's end.
double hop_m(const Experience& run, std::uint32_t newest) {
  double longest = 0.0;
  for (std::uint32_t back = 1; back <= std::min(kLastHops, newest); ++back) {
    const Edge* const hop = run.hop(newest - back);
    if (hop != nullptr) longest = std::max(longest, distance_m(hop->a_from_b));
  }
  return longest > 0.0 ? longest : kHop_m;
}

}  // namespace

std::vector<Touched> touched_by(const Route& route, std::uint32_t from, std::uint32_t to, double footprint_m) {
  std::vector<Touched> touched;
  if (route.places.empty()) return touched;
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  for (std::uint32_t i = from; i <= std::min(to, last); ++i) {
    double slack = kLeastSlack_m;
    if (i > 0) slack = std::max(slack, distance_m(route.relations[i - 1]) / 2);
    if (i < last) slack = std::max(slack, distance_m(route.relations[i]) / 2);
    touched.push_back({.place = route.places[i], .reach_m = footprint_m + slack});
  }
  return touched;
}

Touched touched_beyond(const Snapshot& network, const PlaceId& place, const PlaceId& before, double footprint_m) {
  const Experience* const run = network.experience(place.experience);
  const bool is_begun = run != nullptr && !run->places.empty();
  if (!is_begun) return {.place = before, .reach_m = footprint_m + kLeastSlack_m + kHop_m * (place.index + 1.0)};
  const PlaceId newest = run->places[run->places.size() - 1].id;
  if (place.index <= newest.index) return {};  // it has been taken out of the map
  const double way_m = hop_m(*run, newest.index) * static_cast<double>(place.index - newest.index);
  return {.place = newest, .reach_m = footprint_m + kLeastSlack_m + way_m};
}

}  // namespace weft::server
