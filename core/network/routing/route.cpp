#include <algorithm>

#include "core/network/routing/block_search.hpp"
#include "core/network/routing/routing.hpp"

namespace weft::routing {
namespace {

/// Turns stretches into places.
class Unpacker {
 public:
  explicit Unpacker(const Preparation& preparation, BlockSearch& search)
      : preparation_(preparation), search_(search) {}

  void unpack(const std::vector<BlockSearch::Stretch>& way) {
    for (const BlockSearch::Stretch& stretch : way) {
      if (stretch.is_open || stretch.from == stretch.to) {
        way_.push_back(preparation_.place(stretch.from));
        if (stretch.from != stretch.to) way_.push_back(preparation_.place(stretch.to));
        continue;
      }
      search_.confine(stretch.level, stretch.cell);
      // Rounding may come out a little differently here.
      search_.start(stretch.from, stretch.cost * (1.0 + 1e-9));
      search_.run_to(stretch.to);
      unpack(search_.way_to(stretch.to));
    }
  }
  std::vector<PlaceId> take() { return std::move(way_); }

 private:
  const Preparation& preparation_;
  BlockSearch& search_;
  std::vector<PlaceId> way_;
};

Result<Path> with_relations(const Snapshot& snapshot, std::vector<PlaceId> places,
                            const std::set<std::string>& methods) {
  Path path;
  path.places = std::move(places);
  path.relations.reserve(path.places.size());
  for (std::size_t at = 0; at + 1 < path.places.size(); ++at) {
    const PlaceId& here = path.places[at];
    const Edge* best = nullptr;
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      if (other_end(edge, here) != path.places[at + 1] || !can_drive(edge, here)) return;
      if (!methods.contains(edge.method)) return;
      if (best == nullptr || norm(edge.a_from_b) < norm(best->a_from_b)) best = &edge;
    });
    if (best == nullptr) {
      return fail(ErrorCode::internal, "path: the preparation leads from " + to_string(here) + " to " +
                                           to_string(path.places[at + 1]) + ", which no edge joins");
    }
    path.relations.push_back(relation_from(*best, here));
    path.length_m += distance_m(path.relations.back());
  }
  return path;
}

}  // namespace

Result<std::optional<Path>> find_path(const Preparation& preparation, const Snapshot& snapshot, const PlaceId& from,
                                      const PlaceId& to, const std::set<std::string>& methods) {
  if (preparation.of.revision() != snapshot.revision()) {
    return fail(ErrorCode::stale, "path: routes are prepared for revision " +
                                      std::to_string(preparation.of.revision().value) + ", the network is at " +
                                      std::to_string(snapshot.revision().value) + "; update the preparation");
  }
  if (preparation.methods != methods) {
    return fail(ErrorCode::invalid, "path: routes are prepared for other methods; prepare them for these");
  }
  const Node start = preparation.node(from);
  const Node goal = preparation.node(to);
  if (start == kNoNode || goal == kNoNode) return std::nullopt;
  BlockSearch search(preparation);
  search.search_all(start, goal);
  search.start(start);
  if (search.run_to(goal) == std::numeric_limits<double>::infinity()) return std::nullopt;
  const std::vector<BlockSearch::Stretch> way = search.way_to(goal);
  Unpacker unpacker(preparation, search);
  unpacker.unpack(way);
  Result<Path> path = with_relations(snapshot, unpacker.take(), methods);
  if (!path) return fail(path.error());
  return *std::move(path);
}

Result<Path> shortest_path(const Preparation& preparation, const Snapshot& snapshot, const PlaceId& from,
                           const PlaceId& to, const std::set<std::string>& methods) {
  Result<std::optional<Path>> path = find_path(preparation, snapshot, from, to, methods);
  if (!path) return fail(path.error());
  if (*path) return *std::move(*path);
  return weft::shortest_path(snapshot, from, to, methods);
}

}  // namespace weft::routing
