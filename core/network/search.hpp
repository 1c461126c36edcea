#pragma once
#include <concepts>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/network/network.hpp"
#include "core/network/window.hpp"

namespace weft {

/// Describes a place reached by the search, with the composed relation along the shortest chain of hops.
struct Reached {
  PlaceId id;
  std::uint32_t depth = 0;
  Relation centre_from_place;
};

/// Return Psi_BFS (Gadd & Newman, III-C): all places within `max_depth` hops of `centre`, the centre first, nearest
/// hops first, ties by place id; at most `cap`. Empty if `centre` is not in the window or snapshot.
std::vector<Reached> breadth_first(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap);
std::vector<Reached> breadth_first(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap);

/// Returns the places to which a chain of hops leads that keeps within that distance of `centre`, as composed along
/// the chain: the centre first, nearest hops first; at most `cap`. Empty if `centre` is not in the snapshot.
std::vector<Reached> within(const Snapshot& snapshot, const PlaceId& centre, double distance_m, std::size_t cap);

/// Return the ids alone, without composing relations; same order.
std::vector<PlaceId> neighbourhood(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap);
std::vector<PlaceId> neighbourhood(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap);

/// Holds the shortest chain of drivable edges. `relations[i]` is places[i]_from_places[i + 1].
struct Path {
  std::vector<PlaceId> places;
  std::vector<Relation> relations;
  double length_m = 0.0;
};

/// Finds a shortest path (Dijkstra) by norm of the relation over edges that one of `methods` can drive in the
/// direction of travel. A path from a place to itself has one place and no length. Ties are broken by place id.
/// not_found: a place is unknown, or no drivable path exists; the message says which and how far one gets.
Result<Path> shortest_path(const Snapshot& snapshot, const PlaceId& from, const PlaceId& to,
                           const std::set<std::string>& methods);

/// Returns whether `edge` may be driven when it is left at `from` (which is one of its ends).
bool can_drive(const Edge& edge, const PlaceId& from);
/// Returns from_from_to, `from` being one end of the edge.
Relation relation_from(const Edge& edge, const PlaceId& from);
/// Returns the edge's other end.
PlaceId other_end(const Edge& edge, const PlaceId& from);

}  // namespace weft
