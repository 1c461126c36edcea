#include "core/network/window.hpp"

#include <algorithm>

#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"
#include "core/network/fields.hpp"
#include "core/network/search.hpp"

namespace weft {
namespace {

/// Sorted, each once.
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

}  // namespace

void index_edges(Window& window) {
  window.edges_at.clear();
  window.edges_at.reserve(2 * window.edges.size());
  for (const bool stitches : {false, true}) {
    for (std::uint32_t at = 0; at < window.edges.size(); ++at) {
      if ((window.edges.value_at(at).origin == Origin::stitch) != stitches) continue;
      const EdgeId& id = window.edges.key_at(at);
      window.edges_at.push_back({id.a, at});
      window.edges_at.push_back({id.b, at});
    }
  }
  std::stable_sort(window.edges_at.begin(), window.edges_at.end(),
                   [](const auto& first, const auto& second) { return first.place < second.place; });
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
