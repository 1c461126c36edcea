#include "agents/navigation/ways.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace weft::agents {
namespace {

constexpr double kMostShare = 0.67;  ///< of the way, for a straight to be worth it
constexpr double kMostWay_m = longest_shortcut_m / kMostShare;

/// Returns the lengths of the shortest ways that are driven from a place, up to those that any straight would cut.
std::map<PlaceId, double> ways_from(const Window& map, const PlaceId& from) {
  std::map<PlaceId, double> ways_m;
  using Open = std::pair<double, PlaceId>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.push({0.0, from});
  while (!open.empty()) {
    const auto [way_m, here] = open.top();
    open.pop();
    if (way_m > kMostWay_m || !ways_m.emplace(here, way_m).second) continue;
    map.for_each_edge(here, [&, way = way_m, at = here](const Edge& edge) {
      if (edge.drivable != Drivable::none) open.push({way + distance_m(edge.a_from_b), other_end(edge, at)});
    });
  }
  return ways_m;
}

}  // namespace

std::vector<Detour> worth_cutting(const Window& map, const PlaceId& kept, const std::vector<Reached>& reached) {
  constexpr std::uint32_t least_hops = 2;
  const std::map<PlaceId, double> ways_m = ways_from(map, kept);
  std::vector<Detour> detours;
  for (const Reached& one : reached) {
    if (one.id.experience != kept.experience || one.id.index >= kept.index || one.depth < least_hops) continue;
    const double straight_m = distance_m(one.centre_from_place);
    const auto way = ways_m.find(one.id);
    const double way_m = way == ways_m.end() ? kMostWay_m : way->second;
    if (straight_m > longest_shortcut_m || straight_m >= kMostShare * way_m) continue;
    detours.push_back({one.id, one.centre_from_place, way_m - straight_m});
  }
  std::sort(detours.begin(), detours.end(), [](const Detour& a, const Detour& b) {
    return std::tie(b.saves_m, a.place) < std::tie(a.saves_m, b.place);
  });
  return detours;
}

}  // namespace weft::agents
