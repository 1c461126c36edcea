#include "core/network/search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace weft {
namespace {

/// Lets a window be searched place by place. Nodes sort as the ids of their places do: a window's are positions, as
/// comparing ids is most of the work there.
struct InWindow {
  using Node = std::uint32_t;
  const Window& window;
  std::optional<Node> find(const PlaceId& place) const {
    const std::size_t at = window.places.position(place);
    return at == window.places.size() ? std::nullopt : std::optional(static_cast<Node>(at));
  }
  const PlaceId& id(Node node) const { return window.places.key_at(node); }
  template <class Visit>
  void for_each_edge(Node node, Visit&& visit) const {
    window.for_each_edge_at(node, visit);
  }
};

struct InSnapshot {
  using Node = PlaceId;
  const Snapshot& snapshot;
  std::optional<Node> find(const PlaceId& place) const {
    return snapshot.place(place) == nullptr ? std::nullopt : std::optional(place);
  }
  const PlaceId& id(const Node& node) const { return node; }
  template <class Visit>
  void for_each_edge(const Node& node, Visit&& visit) const {
    snapshot.for_each_edge(node, [&](const Edge& edge) {
      const PlaceId other = other_end(edge, node);
      if (snapshot.place(other) != nullptr) visit(edge, other);
    });
  }
};

/// Describes a way into a place of the next level.
template <class Node>
struct Arrival {
  Node node{};
  std::uint32_t parent = 0;  ///< position in the level before
  const Edge* edge = nullptr;
};

template <class Node>
bool holds(const std::vector<Node>& sorted, const Node& node) {
  return std::binary_search(sorted.begin(), sorted.end(), node);
}

/// Keeps one way into each place: of several, the one from the smallest parent.
template <class Node>
void keep_first_ways(std::vector<Arrival<Node>>& arrivals) {
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) {
    return std::tie(a.node, a.parent) < std::tie(b.node, b.parent);
  });
  arrivals.erase(
      std::unique(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) { return a.node == b.node; }),
      arrivals.end());
}

/// Goes outwards level by level, each sorted by id. A neighbour of a level lies in that level, in the one before or
/// in the next: no set of all visited places is needed. `reach(arrival, depth, first_of_parents)` is called in order.
template <class Graph, class Reach>
void expand(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth, std::uint32_t cap, Reach&& reach) {
  using Node = typename Graph::Node;
  const std::optional<Node> start = graph.find(centre);
  if (cap == 0 || !start) return;
  std::vector<Node> before;
  std::vector<Node> level{*start};
  std::vector<Arrival<Node>> arrivals;
  reach(Arrival<Node>{*start, 0, nullptr}, 0U, std::size_t{0});
  std::size_t reached = 1;
  for (std::uint32_t depth = 1; depth <= max_depth && !level.empty() && reached < cap; ++depth) {
    arrivals.clear();
    for (std::uint32_t parent = 0; parent < level.size(); ++parent) {
      graph.for_each_edge(level[parent], [&](const Edge& edge, const Node& other) {
        if (!holds(level, other) && !holds(before, other)) arrivals.push_back({other, parent, &edge});
      });
    }
    keep_first_ways(arrivals);
    if (arrivals.size() > cap - reached) arrivals.resize(cap - reached);
    const std::size_t first_of_parents = reached - level.size();
    std::swap(before, level);
    level.clear();
    for (const Arrival<Node>& arrival : arrivals) {
      reach(arrival, depth, first_of_parents);
      level.push_back(arrival.node);
    }
    reached += arrivals.size();
  }
}

template <class Graph>
std::vector<Reached> search(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth, std::uint32_t cap) {
  std::vector<Reached> result;
  expand(graph, centre, max_depth, cap, [&](const auto& arrival, std::uint32_t depth, std::size_t first) {
    if (arrival.edge == nullptr) {
      result.push_back({graph.id(arrival.node), 0, Metric2{}});
      return;
    }
    const Reached& parent = result[first + arrival.parent];
    const Relation step = relation_from(*arrival.edge, parent.id);
    // The identity of a kind-less centre must not change the kind of the first relation.
    Relation composed = depth == 1 ? step : compose(parent.centre_from_place, step);
    result.push_back({graph.id(arrival.node), depth, std::move(composed)});
  });
  return result;
}

template <class Graph>
std::vector<PlaceId> search_ids(const Graph& graph, const PlaceId& centre, std::uint32_t max_depth,
                                std::uint32_t cap) {
  std::vector<PlaceId> ids;
  expand(graph, centre, max_depth, cap,
         [&](const auto& arrival, std::uint32_t, std::size_t) { ids.push_back(graph.id(arrival.node)); });
  return ids;
}

}  // namespace

std::vector<Reached> breadth_first(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search(InWindow{window}, centre, max_depth, cap);
}

std::vector<Reached> breadth_first(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search(InSnapshot{snapshot}, centre, max_depth, cap);
}

std::vector<Reached> within(const Snapshot& snapshot, const PlaceId& centre, double distance_m, std::size_t cap) {
  if (snapshot.place(centre) == nullptr || cap == 0) return {};
  std::vector<Reached> reached = {{centre, 0, Metric2{}}};
  std::set<PlaceId> seen = {centre};
  for (std::size_t at = 0; at < reached.size(); ++at) {
    const Reached here = reached[at];
    InSnapshot{snapshot}.for_each_edge(here.id, [&](const Edge& edge, const PlaceId& there) {
      if (reached.size() == cap || !seen.insert(there).second) return;
      const Relation step = relation_from(edge, here.id);
      // The identity of a kind-less centre must not change the kind of the first relation.
      Relation relation = here.depth == 0 ? step : compose(here.centre_from_place, step);
      if (weft::distance_m(relation) > distance_m) return;
      reached.push_back({there, here.depth + 1, std::move(relation)});
    });
  }
  return reached;
}

std::vector<PlaceId> neighbourhood(const Window& window, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search_ids(InWindow{window}, centre, max_depth, cap);
}

std::vector<PlaceId> neighbourhood(const Snapshot& snapshot, const PlaceId& centre, std::uint32_t max_depth,
                                   std::uint32_t cap) {
  return search_ids(InSnapshot{snapshot}, centre, max_depth, cap);
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
