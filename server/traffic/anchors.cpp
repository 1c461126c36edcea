#include "server/traffic/anchors.hpp"

#include <map>
#include <tuple>

#include "core/network/search.hpp"

namespace weft::server {
namespace {

constexpr std::size_t kMostAnchors = 16;
constexpr std::size_t kMostPassed = 8192;

}  // namespace

std::vector<Anchor> anchors_of(const TrafficMap& map, const PlaceId& gone) {
  std::vector<Anchor> anchors;
  std::map<PlaceId, double> known = {{gone, 0.0}};
  std::map<std::tuple<double, PlaceId>, Metric2> open = {{{0.0, gone}, Metric2{}}};
  for (std::size_t passed = 0; !open.empty() && passed < kMostPassed && anchors.size() < kMostAnchors; ++passed) {
    const auto [uncertainty, place] = open.begin()->first;
    const Metric2 gone_from_place = open.begin()->second;
    open.erase(open.begin());
    if (uncertainty > known.at(place)) continue;
    if (map.is_in(place)) {
      anchors.push_back({.place = place, .place_from_it = std::get<Metric2>(inverse(gone_from_place))});
      continue;
    }
    map.for_each_edge(place, [&, from = place, before = uncertainty](const Edge& edge) {
      const PlaceId next = other_end(edge, from);
      if (!map.has(next)) return;
      const double with_edge = before + uncertainty_of(edge);
      const auto [at, is_new] = known.try_emplace(next, with_edge);
      if (!is_new && at->second <= with_edge) return;
      at->second = with_edge;
      const Relation step = laid_flat(relation_from(edge, from));
      open[{with_edge, next}] = std::get<Metric2>(compose(gone_from_place, step));
    });
  }
  return anchors;
}

}  // namespace weft::server
