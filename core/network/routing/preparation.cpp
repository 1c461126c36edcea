#include "core/network/routing/preparation.hpp"

namespace weft::routing {

Node Preparation::node(const PlaceId& place) const {
  const auto* const known = nodes.value(place.experience);
  return known == nullptr || place.index >= (*known)->size() ? kNoNode : (**known)[place.index];
}

std::size_t size_bytes(const Preparation& preparation) {
  const auto of = [](const auto& row) { return row.capacity() * sizeof(row[0]); };
  std::size_t bytes = of(preparation.base) + of(preparation.cells);
  for (const auto& cell : preparation.base) {
    bytes +=
        sizeof(*cell) + of(cell->places) + of(cell->first_arc) + of(cell->arcs) + of(cell->entered) + of(cell->left);
  }
  for (const auto& level : preparation.overlays) {
    for (const auto& overlay : level) {
      bytes += sizeof(*overlay) + of(overlay->children) + of(overlay->entries) + of(overlay->exits) +
               of(overlay->costs) + of(overlay->first_crossing) + of(overlay->crossings);
    }
  }
  for (const auto& [id, nodes] : preparation.nodes) bytes += sizeof(id) + of(*nodes);
  return bytes;
}

}  // namespace weft::routing
