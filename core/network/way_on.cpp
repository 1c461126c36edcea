#include "core/network/way_on.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include "core/network/beside.hpp"
#include "core/network/search.hpp"

namespace weft {
namespace {

/// Bounds the places that are looked at in each direction.
constexpr std::size_t kMost = 1024;
/// Bounds the places beside the first one from which a robot may set off, as the dispatcher tries them.
constexpr std::size_t kBeside = 6;

using Places = std::map<PlaceId, std::size_t>;  ///< numbered as they were found

bool is_ours(const Edge& edge, const std::set<std::string>& methods) {
  return methods.contains(edge.method);
}

/// Collects what can be reached from `from`, or, backwards, what reaches it. None: more than is looked at.
template <class Leads>
std::optional<Places> collect(const Snapshot& snapshot, std::vector<PlaceId> open, const Leads& leads) {
  Places found;
  for (const PlaceId& place : open) found.emplace(place, found.size());
  while (!open.empty()) {
    const PlaceId here = open.back();
    open.pop_back();
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      const PlaceId there = other_end(edge, here);
      if (leads(edge, here, there) && found.emplace(there, found.size()).second) open.push_back(there);
    });
    if (found.size() > kMost) return std::nullopt;
  }
  return found;
}

/// Returns whether a way among these places leads round. A stitch that is driven both ways joins two runs at one
/// spot, and leads nowhere: its ends count as one.
bool leads_round(const Snapshot& snapshot, const Places& places, const std::set<std::string>& methods) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  Graph spots(places.size());
  std::vector<std::pair<std::size_t, std::size_t>> hops;
  for (const auto& [here, number] : places) {
    snapshot.for_each_edge(here, [&, from = number, at = here](const Edge& edge) {
      const auto there = places.find(other_end(edge, at));
      if (there == places.end() || !is_ours(edge, methods) || !can_drive(edge, at)) return;
      const bool is_spot = edge.origin == Origin::stitch && can_drive(edge, there->first);
      if (is_spot) {
        boost::add_edge(from, there->second, spots);
      } else {
        hops.emplace_back(from, there->second);
      }
    });
  }
  std::vector<std::size_t> spot_of(places.size());
  Graph ways(boost::strong_components(spots, spot_of.data()));
  for (const auto& [from, to] : hops) {
    if (spot_of[from] != spot_of[to]) boost::add_edge(spot_of[from], spot_of[to], ways);
  }
  std::vector<std::size_t> part_of(boost::num_vertices(ways));
  return boost::strong_components(ways, part_of.data()) < boost::num_vertices(ways);
}

}  // namespace

WayOn way_on(const Snapshot& snapshot, const PlaceId& place, const std::set<std::string>& methods) {
  std::vector<PlaceId> starts = places_beside(snapshot, place);
  starts.resize(std::min(starts.size(), kBeside));
  starts.insert(starts.begin(), place);
  const std::optional<Places> ahead =
      collect(snapshot, starts, [&](const Edge& edge, const PlaceId& here, const PlaceId&) {
        return is_ours(edge, methods) && can_drive(edge, here);
      });
  if (!ahead) return {.leads_on = true, .places = 0};
  const WayOn ends{.leads_on = false, .places = ahead->size() - starts.size()};
  if (!leads_round(snapshot, *ahead, methods)) return ends;
  // Robots come from what leads there, and cannot go back where that has ways round of its own.
  std::vector<PlaceId> known;
  for (const auto& [there, number] : *ahead) known.push_back(there);
  std::optional<Places> behind =
      collect(snapshot, known, [&](const Edge& edge, const PlaceId&, const PlaceId& there) {
        return is_ours(edge, methods) && can_drive(edge, there) && !ahead->contains(there);
      });
  if (!behind) return ends;
  for (const PlaceId& there : known) behind->erase(there);
  std::size_t number = 0;
  for (auto& [there, is] : *behind) is = number++;
  return {.leads_on = !leads_round(snapshot, *behind, methods), .places = ends.places};
}

std::set<std::string> methods_in(const Snapshot& snapshot) {
  std::set<std::string> methods;
  for (const auto& [id, experience] : snapshot.experiences()) methods.insert(experience->method);
  return methods;
}

std::string no_way_on(const Snapshot& snapshot, const PlaceId& place, const std::set<std::string>& methods) {
  const WayOn way = way_on(snapshot, place, methods);
  if (way.leads_on) return {};
  return (way.places == 0 ? std::string("nothing leads on from there")
                          : "what leads on from there ends after " + std::to_string(way.places) + " places") +
         ": teach a run on from there that a robot can come back by";
}

}  // namespace weft
