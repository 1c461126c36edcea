#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "agents/navigation/agreement.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "agents/navigation/ways.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

/// Returns the places that may tell whether ways from a kept place are free: those within reach of such a way, along
/// however long a way they were driven.
inline std::vector<Reached> near_ways_from(const Window& map, const PlaceId& kept, std::size_t most) {
  constexpr std::uint32_t hops = 60;
  constexpr std::uint32_t most_reached = 1000;
  constexpr double most_m = 6.0;
  std::vector<Reached> near = breadth_first(map, kept, hops, most_reached);
  std::erase_if(near, [](const Reached& one) { return distance_m(one.centre_from_place) > most_m; });
  if (near.size() > most) near.erase(near.begin() + static_cast<std::ptrdiff_t>(most), near.end());
  return near;
}

/// Returns the part of a map that one run has taught.
inline Window only(const Window& map, const ExperienceId& run) {
  Window part;
  part.revision = map.revision;
  for (const auto& [id, place] : map.places)
    if (id.experience == run) part.places.emplace(id, place);
  for (const auto& [id, edge] : map.edges)
    if (id.a.experience == run && id.b.experience == run) part.edges.emplace(id, edge);
  index_edges(part);
  return part;
}

/// Returns a chart of places, in the frame of the first one.
template <ChartsItself M>
typename M::Chart chart_of(const M& method, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
                           const std::vector<Reached>& places) {
  std::vector<ChartPlace<typename M::Content>> charted;
  for (const Reached& one : places) {
    const auto content = decoded.find(*map.place(one.id), bytes);
    charted.push_back({one.id, one.depth, one.centre_from_place, content ? *content : nullptr});
  }
  return method.chart(charted);
}

/// Returns the edges of straight ways from a place just kept to places of its own run that nobody has driven, where
/// the method sees that they are free: all robots of the method drive them, in either direction (Dayoub et al. 2013,
/// IV-C). The method is asked for at most two, those that save most. `map` holds the kept place and its edges; what
/// other runs have seen does not count, nor ways over them: that the run lies beside these may not be proven.
template <Clears M>
std::vector<Edge> shortcuts(const M& method, const NavigationConfig& config, const Window& map, const Contents& bytes,
                            DecodedContents<M>& decoded, const PlaceId& kept) {
  constexpr std::size_t most_asked = 2;
  const Window own = only(map, kept.experience);
  const std::vector<Reached> near = near_ways_from(own, kept, M::chart_size.places);
  std::vector<Detour> detours = worth_cutting(own, kept, near);
  std::erase_if(
      detours, [&](const Detour& detour) { return spread_of(detour.kept_from_place).metres > config.stitch.sure_m; });
  detours.resize(std::min(detours.size(), most_asked));
  std::vector<Edge> found;
  if (detours.empty()) return found;
  const typename M::Chart chart = chart_of(method, own, bytes, decoded, near);
  for (const Detour& detour : detours) {
    const Relation place_from_kept = inverse(detour.kept_from_place);
    if (!method.is_clear(chart, planar(detour.kept_from_place), planar(place_from_kept))) continue;
    Edge edge;
    edge.id = {detour.place, kept};
    edge.a_from_b = place_from_kept;
    edge.origin = Origin::stitch;
    edge.method = std::string(M::name);
    edge.drivable = Drivable::both;
    found.push_back(std::move(edge));
  }
  return found;
}

}  // namespace weft::agents
