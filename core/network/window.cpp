#include "core/network/window.hpp"

#include <set>

#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"
#include "core/network/search.hpp"

namespace weft {
namespace {

std::set<PlaceId> choose(const Snapshot& snapshot, const WindowDefinition& definition) {
  std::set<PlaceId> chosen;
  for (const PlaceId& id : definition.route) {
    if (snapshot.place(id) != nullptr) chosen.insert(id);
  }
  if (definition.centre) {
    for (const PlaceId& id : neighbourhood(snapshot, *definition.centre, definition.hops, definition.cap)) {
      if (chosen.size() >= definition.cap) return chosen;
      chosen.insert(id);
    }
    return chosen;
  }
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) {
      if (chosen.size() >= definition.cap) return chosen;
      chosen.insert(place.id);
    }
  }
  return chosen;
}

}  // namespace

void index_edges(Window& window) {
  window.edges_at.clear();
  for (const bool stitches : {false, true}) {
    for (const auto& [id, edge] : window.edges) {
      if ((edge.origin == Origin::stitch) != stitches) continue;
      window.edges_at.emplace(id.a, id);
      window.edges_at.emplace(id.b, id);
    }
  }
}

Window make_window(const Snapshot& snapshot, const WindowDefinition& definition) {
  Window window;
  window.revision = snapshot.revision();
  const std::set<PlaceId> chosen = choose(snapshot, definition);
  for (const PlaceId& id : chosen) {
    window.places.emplace_hint(window.places.end(), id, *snapshot.place(id));
    snapshot.for_each_edge(id, [&](const Edge& edge) {
      if (edge.id.a == id && chosen.contains(edge.id.b)) window.edges.emplace(edge.id, edge);
    });
  }
  for (const auto& [label, place] : snapshot.labels()) {
    if (chosen.contains(place)) window.labels.emplace(label, place);
  }
  index_edges(window);
  return window;
}

Digest digest(const Window& window) {
  ByteWriter out;
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
    out.id(hash_bytes(encode(edge)));
  }
  out.count(window.labels.size());
  for (const auto& [label, place] : window.labels) {
    out.text(label);
    out.id(place);
  }
  return {hash_bytes(out.view()).bytes};
}

}  // namespace weft
