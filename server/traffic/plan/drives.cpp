#include "server/traffic/plan/drives.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

namespace weft::server {
namespace {

struct Open {
  double length_m = 0.0;
  PlaceId place;
  PlaceId before;
  bool operator<(const Open& other) const {  // the nearest one is the top of a heap
    return std::tie(other.length_m, other.place, other.before) < std::tie(length_m, place, before);
  }
};

std::vector<PlaceId> way_to(const std::map<PlaceId, PlaceId>& before, const PlaceId& from, PlaceId to) {
  std::vector<PlaceId> places;
  for (; to != from; to = before.at(to)) places.push_back(to);
  std::reverse(places.begin(), places.end());
  return places;
}

}  // namespace

std::vector<Drive> drives(const Drivables& drivables, const PlaceId& from, Heading heading,
                          const std::function<Stop(const PlaceId&)>& stops) {
  std::vector<Drive> found;
  std::map<PlaceId, PlaceId> before;
  std::priority_queue<Open> open;
  open.push({0.0, from, from});
  while (!open.empty()) {
    const Open here = open.top();
    open.pop();
    if (!before.emplace(here.place, here.before).second) continue;
    const Stop stop = here.place == from ? Stop::none : stops(here.place);
    if (stop != Stop::none) found.push_back({here.place, here.length_m, way_to(before, from, here.place)});
    if (stop == Stop::end || here.length_m > drivables.farthest_m) continue;
    drivables.network.for_each_edge(here.place, [&](const Edge& edge) {
      const PlaceId there = other_end(edge, here.place);
      const PlaceId& leaves = heading == Heading::onward ? here.place : there;
      const PlaceId& enters = heading == Heading::onward ? there : here.place;
      if (!can_drive(edge, leaves) || !drivables.methods.contains(edge.method) || before.contains(there)) return;
      // Counts a robot from far away as beginning where it leaves: it begins no nearer.
      Passage passage = drivables.passage;
      if (heading == Heading::backward) passage.begins = leaves;
      if (drivables.rules.bars(leaves, enters, passage)) return;
      open.push({here.length_m + norm(edge.a_from_b), there, here.place});
    });
  }
  return found;
}

}  // namespace weft::server
