#include "core/network/search.hpp"

#include <algorithm>
#include <tuple>

namespace weft {
namespace {

/// A way into a place of the next level.
struct Arrival {
  PlaceId id;
  std::uint32_t parent = 0;  ///< position in the level before
  const Edge* edge = nullptr;
};

bool holds(const std::vector<PlaceId>& sorted, const PlaceId& id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

/// Level by level, each sorted by id. A neighbour of a level lies in that level, in the one before or in the next:
/// no set of all visited places is needed. `reach(arrival, depth, first_of_parents)` is called in order.
template <class Graph, class Reach>
void expand(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth, std::uint32_t cap, Reach&& reach) {
  if (cap == 0 || graph.place(centre) == nullptr) return;
  std::vector<PlaceId> before;
  std::vector<PlaceId> level{centre};
  reach(Arrival{centre, 0, nullptr}, 0U, std::size_t{0});
  std::size_t reached = 1;
  for (std::uint32_t depth = 1; depth <= max_depth && !level.empty() && reached < cap; ++depth) {
    std::vector<Arrival> arrivals;
    for (std::uint32_t parent = 0; parent < level.size(); ++parent) {
      graph.for_each_edge(level[parent], [&](const Edge& edge) {
        const PlaceId other = other_end(edge, level[parent]);
        if (!holds(level, other) && !holds(before, other) && graph.place(other) != nullptr) {
          arrivals.push_back({other, parent, &edge});
        }
      });
    }
    // Of several ways into a place the one from the smallest parent counts.
    std::stable_sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
      return std::tie(a.id, a.parent) < std::tie(b.id, b.parent);
    });
    arrivals.erase(std::unique(arrivals.begin(), arrivals.end(),
                               [](const Arrival& a, const Arrival& b) { return a.id == b.id; }),
                   arrivals.end());
    if (arrivals.size() > cap - reached) arrivals.resize(cap - reached);
    const std::size_t first_of_parents = reached - level.size();
    before = std::move(level);
    level.clear();
    for (const Arrival& arrival : arrivals) {
      reach(arrival, depth, first_of_parents);
      level.push_back(arrival.id);
    }
    reached += arrivals.size();
  }
}

template <class Graph>
std::vector<Reached> search(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth, std::uint32_t cap) {
  std::vector<Reached> result;
  expand(graph, centre, max_depth, cap, [&](const Arrival& arrival, std::uint32_t depth, std::size_t first) {
    if (arrival.edge == nullptr) {
      result.push_back({arrival.id, 0, Metric2{}});
      return;
    }
    const Reached& parent = result[first + arrival.parent];
    const Relation step = relation_from(*arrival.edge, parent.id);
    // The identity of a kind-less centre must not change the kind of the first relation.
    Relation composed = depth == 1 ? step : compose(parent.centre_from_place, step);
    result.push_back({arrival.id, depth, std::move(composed)});
  });
  return result;
}

template <class Graph>
std::vector<PlaceId> search_ids(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth,
                                std::uint32_t cap) {
  std::vector<PlaceId> ids;
  expand(graph, centre, max_depth, cap,
         [&](const Arrival& arrival, std::uint32_t, std::size_t) { ids.push_back(arrival.id); });
  return ids;
}

}  // namespace

std::vector<Reached> breadth_first(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search(window, centre, max_depth, cap);
}

std::vector<Reached> breadth_first(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search(snapshot, centre, max_depth, cap);
}

std::vector<PlaceId> neighbourhood(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search_ids(window, centre, max_depth, cap);
}

std::vector<PlaceId> neighbourhood(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search_ids(snapshot, centre, max_depth, cap);
}

bool can_drive(const Edge& edge, const PlaceId& from) {
  const auto bits = static_cast<unsigned>(edge.drivable);
  if (from == edge.id.a) return (bits & static_cast<unsigned>(Drivable::a_to_b)) != 0;
  return from == edge.id.b && (bits & static_cast<unsigned>(Drivable::b_to_a)) != 0;
}

Relation relation_from(const Edge& edge, const PlaceId& from) {
  return from == edge.id.a ? edge.a_from_b : inverse(edge.a_from_b);
}

PlaceId other_end(const Edge& edge, const PlaceId& from) {
  return from == edge.id.a ? edge.id.b : edge.id.a;
}

}  // namespace weft
