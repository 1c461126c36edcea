#include "core/network/window.hpp"

#include <algorithm>
#include <numeric>

#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"
#include "core/network/fields.hpp"
#include "core/network/search.hpp"

namespace weft {
namespace {

/// Chooses the places of a window: sorted, each once.
std::vector<PlaceId> choose(const Snapshot& snapshot, const WindowDefinition& definition) {
  std::vector<PlaceId> chosen;
  for (const PlaceId& id : definition.route) {
    if (snapshot.place(id) != nullptr) chosen.push_back(id);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  const auto route_end = static_cast<std::ptrdiff_t>(chosen.size());
  const auto add = [&](const PlaceId& id) {
    if (chosen.size() >= definition.cap) return false;
    if (!std::binary_search(chosen.begin(), chosen.begin() + route_end, id)) chosen.push_back(id);
    return true;
  };
  if (definition.centre) {
    const auto near = neighbourhood(snapshot, *definition.centre, definition.hops, definition.cap);
    std::all_of(near.begin(), near.end(), add);
  } else {
    for (const auto& [id, experience] : snapshot.experiences()) {
      const auto add_place = [&](const Place& place) { return add(place.id); };
      if (!std::all_of(experience->places.begin(), experience->places.end(), add_place)) break;
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Holds the positions of an edge and of its ends.
struct BothEnds {
  std::uint32_t at = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// Finds both ends of each edge. Edges are sorted by their first ends, and most second ends are the next place.
std::vector<BothEnds> both_ends(const Window& window, std::optional<PlaceId>& outside) {
  const std::size_t places = window.places.size();
  std::vector<BothEnds> edges;
  edges.reserve(window.edges.size());
  std::size_t a = 0;
  for (std::uint32_t at = 0; at < window.edges.size(); ++at) {
    const EdgeId& id = window.edges.key_at(at);
    while (a < places && window.places.key_at(a) < id.a) ++a;
    const bool a_inside = a < places && window.places.key_at(a) == id.a;
    const bool is_next = a + 1 < places && window.places.key_at(a + 1) == id.b;
    const std::size_t b = is_next ? a + 1 : window.places.position(id.b);
    if (a_inside && b < places) {
      edges.push_back({at, static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    } else if (!outside) {
      outside = a_inside ? id.b : id.a;
    }
  }
  return edges;
}

}  // namespace

std::optional<PlaceId> index_edges(Window& window) {
  std::optional<PlaceId> outside;
  const std::vector<BothEnds> edges = both_ends(window, outside);
  window.first_end.assign(window.places.size() + 1, 0);
  for (const BothEnds& edge : edges) {
    ++window.first_end[edge.a + 1];
    ++window.first_end[edge.b + 1];
  }
  std::partial_sum(window.first_end.begin(), window.first_end.end(), window.first_end.begin());
  window.ends.resize(2 * edges.size());
  std::vector<std::uint32_t> next = window.first_end;
  for (const bool stitches : {false, true}) {
    for (const BothEnds& edge : edges) {
      if ((window.edges.value_at(edge.at).origin == Origin::stitch) != stitches) continue;
      window.ends[next[edge.a]++] = {edge.at, edge.b};
      window.ends[next[edge.b]++] = {edge.at, edge.a};
    }
  }
  return outside;
}

Window make_window(const Snapshot& snapshot, const WindowDefinition& definition) {
  Window window;
  window.revision = snapshot.revision();
  const std::vector<PlaceId> chosen = choose(snapshot, definition);
  const auto inside = [&](const PlaceId& id) { return std::binary_search(chosen.begin(), chosen.end(), id); };
  window.places.reserve(chosen.size());
  for (const PlaceId& id : chosen) {
    window.places.emplace(id, *snapshot.place(id));
    snapshot.for_each_edge(id, [&](const Edge& edge) {
      if (edge.id.a == id && inside(edge.id.b)) window.edges.emplace(edge.id, edge);
    });
  }
  for (const auto& [label, place] : snapshot.labels()) {
    if (inside(place)) window.labels.emplace(label, place);
  }
  index_edges(window);
  return window;
}

Digest digest(const Window& window) {
  ByteWriter out;
  ByteWriter record;
  out.reserve(16 + 48 * window.places.size() + 60 * window.edges.size() + 80 * window.labels.size());
  out.count(window.places.size());
  for (const auto& [id, place] : window.places) {
    out.id(id);
    out.number(place.entity_version);
    out.id(place.content.hash);
  }
  out.count(window.edges.size());
  for (const auto& [id, edge] : window.edges) {
    out.id(id.a);
    out.id(id.b);
    out.number(edge.entity_version);
    record.clear();
    record.number(fields::kFormat);
    fields::write(record, edge);
    out.id(hash_bytes(record.view()));
  }
  out.count(window.labels.size());
  for (const auto& [label, place] : window.labels) {
    out.text(label);
    out.id(place);
  }
  return {hash_bytes(out.view()).bytes};
}

}  // namespace weft
