#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/flat_map.hpp"
#include "core/network/network.hpp"

namespace weft {

/// Defines the part of the network that an agent wants. Together with a snapshot it fixes the window, nothing else
/// does.
struct WindowDefinition {
  std::optional<PlaceId> centre;  ///< none: the whole network, up to the cap
  std::uint32_t hops = 25;        ///< breadth-first depth around the centre
  std::uint32_t cap = 2000;       ///< most places; nearest first, ties by id. [1, 1000000]
  std::vector<PlaceId> route;     ///< always in as far as it exists, beyond the cap too; before the neighbourhood
  bool operator==(const WindowDefinition&) const = default;
};

/// Holds the part of the network that one agent has: places, edges with both ends inside, labels of places inside.
struct Window {
  Revision revision;
  FlatMap<PlaceId, Place> places;
  FlatMap<EdgeId, Edge> edges;
  std::map<std::string, PlaceId> labels;

  const Place* place(const PlaceId& id) const { return places.value(id); }
  /// Visits edges as Snapshot::for_each_edge does. Linear only in the edges at `id`.
  template <class Visit>
  void for_each_edge(const PlaceId& id, Visit&& visit) const;

  /// Calls `visit(const Edge&, std::uint32_t)` with the position of each edge's other end; the same order.
  template <class Visit>
  void for_each_edge_at(std::uint32_t position, Visit&& visit) const;

  struct EdgeEnd {
    std::uint32_t edge = 0;   ///< position in `edges`
    std::uint32_t other = 0;  ///< position in `places` of the edge's other end
    bool operator==(const EdgeEnd&) const = default;
  };
  /// Lists the ends at each place, one place's after the other's; kept by `make_window` and `apply` so that edges are
  /// found from either end.
  std::vector<EdgeEnd> ends;
  std::vector<std::uint32_t> first_end;  ///< of each place in `ends`, and the number of all
};

/// Makes `ends` anew; to be called when places or edges were added or removed. Edges that lead out of the window are
/// left out of it; returns an end outside, if there is one.
std::optional<PlaceId> index_edges(Window& window);

Window make_window(const Snapshot& snapshot, const WindowDefinition& definition);

/// Returns the SHA-256 over sorted (id, entity version, content hash) of places, then edges, then labels (an edge's
/// and a label's "content hash" is that of its canonical bytes).
Digest digest(const Window& window);

/// Describes the difference of two windows; contents by hash only.
struct Patch {
  Revision base;  ///< 0: from the empty window
  Revision target;
  std::vector<Place> added;  ///< places new in the window
  std::vector<Place> changed;
  std::vector<PlaceId> removed;
  std::vector<Edge> edges;  ///< new or changed
  std::vector<EdgeId> edges_removed;
  std::map<std::string, PlaceId> labels;
  std::vector<std::string> labels_removed;
  Digest digest;  ///< of the target window
};

Patch difference(const Window& base, const Window& target);
/// Returns the same, with a digest of `target` that the caller has already: to compute it takes longer than all the
/// rest.
Patch difference(const Window& base, const Window& target, const Digest& target_digest);
/// Returns the window with the patch applied. A patch from the empty window (base 0) replaces the window, whatever it
/// was.
/// stale: the patch is not made from this window's revision. corrupt: the result's digest is not the patch's, or an
/// edge or a label points out of the window. In both cases the window stays unchanged, and a fresh one is to be got.
Result<Window> apply(const Window& base, const Patch& patch);

/// Splits the patch into parts of at most `max_entities` (>= 1) places, edges, labels and removals; all parts share
/// base, target and digest. At least one part.
std::vector<Patch> split(const Patch& patch, std::size_t max_entities);
/// Joins all parts into one. corrupt: none, or parts of different patches.
Result<Patch> join(const std::vector<Patch>& parts);

template <class Visit>
void Window::for_each_edge(const PlaceId& id, Visit&& visit) const {
  const std::size_t position = places.position(id);
  if (position == places.size()) return;
  for_each_edge_at(static_cast<std::uint32_t>(position), [&](const Edge& edge, std::uint32_t) { visit(edge); });
}

template <class Visit>
void Window::for_each_edge_at(std::uint32_t position, Visit&& visit) const {
  if (position + 1 >= first_end.size()) return;
  for (std::uint32_t at = first_end[position]; at < first_end[position + 1]; ++at) {
    visit(edges.value_at(ends[at].edge), ends[at].other);
  }
}

}  // namespace weft
