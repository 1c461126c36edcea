#include "server/traffic/local_layouts.hpp"

#include <algorithm>
#include <memory>

namespace weft::server {
namespace {

constexpr std::uint32_t kPlacesOfBlock = 32;
constexpr std::size_t kPlacesAround = 3000;
constexpr std::size_t kMostBlocks = 64;
/// Bounds how many revisions a layout may be old that does not have the other place: one that is too far away is not
/// looked for anew with each batch.
constexpr std::uint64_t kRevisionsKept = 200;

}  // namespace

/// Returns the layout around the place, made anew when the network has grown since by what is asked about.
const Layout& LocalLayouts::around(const Snapshot& network, const PlaceId& place, const PlaceId& other) {
  const Block block{place.experience, place.index / kPlacesOfBlock};
  const auto known = around_.find(block);
  if (known != around_.end()) {
    const Around& before = known->second;
    const bool is_young = network.revision().value < before.of.value + kRevisionsKept;
    const bool has_place = before.layout.part_of(place) || network.place(place) == nullptr;
    if (has_place && (is_young || before.layout.part_of(other))) return before.layout;
    around_.erase(known);
  }
  if (around_.size() >= kMostBlocks) around_.clear();
  Around& made = around_[block];
  made.of = network.revision();
  // LocatedPlace at now alone: it does not outlive the call.
  made.layout.lay_around(Layout::Network(Layout::Network(), &network), place, kPlacesAround);
  return made.layout;
}

void LocalLayouts::joined(const Batch& batch) {
  std::erase_if(around_, [&](const auto& entry) {
    const Layout& layout = entry.second.layout;
    return std::any_of(batch.edges.begin(), batch.edges.end(), [&](const Edge& edge) {
      return layout.part_of(edge.id.a).has_value() || layout.part_of(edge.id.b).has_value();
    });
  });
}

bool LocalLayouts::are_clear(const Snapshot& network, const PlaceId& a, const PlaceId& b, double reach_m) {
  const Layout& layout = around(network, b, a);
  const std::optional<Spot> of_a = layout.spot(a);
  const std::optional<Spot> of_b = layout.spot(b);
  return of_a && of_b && !layout.are_near(*of_a, *of_b, reach_m);
}

}  // namespace weft::server
